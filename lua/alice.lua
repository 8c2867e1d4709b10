-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What the studies of ALICE's topologic maps share: a robot that explores a world and makes its map, the truth beside it.
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"

local alice = { worlds = { "alice_loop", "alice_rooms", "alice_grid" } }

--- Explores a world. `options`: world (a name), seed, samples, correction (false: dead reckoning alone), drift ('alice'),
--- map (options of the map), wander (options of the guide), begin(world) called first, each(sample, robot) called after every cycle. Returns the robot: {world, sim, map, scores}.
function alice.explore(options)
  local world = meander.world.open("worlds/" .. options.world .. ".toml")
  if options.begin then options.begin(world) end
  local settings = {}
  for key, value in pairs(options.map or {}) do settings[key] = value end
  if options.correction == false then settings.correlation = { gain = 0, turn_gain = 0 } end
  local wander = { samples = options.samples, seed = options.seed }
  for key, value in pairs(options.wander or {}) do wander[key] = value end
  local sim = meander.sim.new { world = world, robot = "alice", drift = options.drift or "alice", seed = options.seed }
  local robot = { world = world, sim = sim, map = meander.topology.map(settings) }
  robot.scores = meander.study.place_scores(sim)
  wander.map = robot.map
  local sample = 0
  sim:drive {
    navigator = meander.topology.whiskers { patience = 1e6 },
    guide = meander.topology.wander(wander),
    time_limit = 1e6, record_every = 0,
    on_step = function()
      sample = sample + 1
      robot.scores:add(robot.map)
      if options.each then options.each(sample, robot) end
    end,
  }
  return robot
end

local kLast = 1000 -- drives begin at moments of so many last samples of an exploration

local function between(options) return math.max(1, kLast // options.goals) end

--- The first sample at which a drive begins: one past the last where there are none.
function alice.first_moment(options)
  if options.goals == 0 then return options.samples + 1 end
  local left = math.min(kLast, options.samples) - 1
  return options.samples - left // between(options) * between(options)
end

--- Keeps this moment of the robot, {sim, map}, if it is one of the `goals` at which drives begin.
function alice.keep_moment(moments, options, sample, robot)
  if #moments >= options.goals or sample < alice.first_moment(options) then return end
  if (options.samples - sample) % between(options) == 0 then
    moments[#moments + 1] = { sim = robot.sim:fork(), map = robot.map:copy() }
  end
end

--- A place of the robot's map chosen by chance, of those whose true place is known.
function alice.goal(robot)
  local places = robot.map.places
  local known = false
  for _, place in ipairs(places) do known = known or robot.scores:true_place(robot.map, place.number) ~= nil end
  if not known then error("no place of the map has a true place yet; more --samples expected", 0) end
  local goal
  repeat goal = places[math.random(#places)].number until robot.scores:true_place(robot.map, goal)
  return goal
end

--- Sends a copy of the robot to a place of its map. Independent of all other drives. Returns whether it arrived, whether
--- it wrongly believed so, and the reason.
function alice.go(robot, place, options)
  local target = robot.scores:true_place(robot.map, place)
  local sim, map = robot.sim:fork(), robot.map:copy()
  local run = sim:drive {
    navigator = meander.topology.whiskers { patience = 1e6 },
    guide = meander.topology.route { map = map, to = place, route = options and options.route },
    time_limit = 1e6, record_every = 0,
  }
  local at = sim.state.pose
  local near = math.sqrt((at[1] - target.x) ^ 2 + (at[2] - target.y) ^ 2) < 0.5
  return run.success and near, run.success and not near, run.reason, run
end

--- Runs trial(seed) for all seeds of the command line; their values in order.
function alice.trials(options, trial)
  local seeds, values = {}, {}
  for i = 1, options.seeds do seeds[i] = options.first_seed + i - 1 end
  for _, result in ipairs(meander.study.trials { seeds = seeds, jobs = options.jobs, trial = trial }) do
    if not result.ok then report.failure(("seed %d: %s"):format(result.seed, result.error)) end
    values[#values + 1] = result.value
  end
  return values
end

--- One line of a study: fixed words first, then the means of figures over the trials with their intervals. `names` lists
--- the figures; trials without one do not count for it, and a figure of no trial is no number (null in JSON).
function alice.line(words, trials, names)
  local line, keys = {}, {}
  local function put(key, value)
    line[key] = value
    keys[#keys + 1] = key
  end
  for _, word in ipairs(words) do put(word[1], word[2]) end
  for _, name in ipairs(names) do
    local values = {}
    for _, trial in ipairs(trials) do values[#values + 1] = trial[name] end
    if #values == 0 then
      put(name, 0 / 0)
    else
      local mean, low, high = meander.study.bootstrap_mean(values)
      put(name, candidates.rounded(mean, 4))
      put(name .. "_low", candidates.rounded(low, 4))
      put(name .. "_high", candidates.rounded(high, 4))
    end
  end
  return line, keys
end

--- Prints such a line as JSON or as text.
function alice.print(options, words, trials, names)
  local line, keys = alice.line(words, trials, names)
  if options.json then return print(json.encode(line, keys)) end
  local text = {}
  for _, word in ipairs(words) do text[#text + 1] = word[1] .. " " .. tostring(word[2]) end
  for _, name in ipairs(names) do
    if line[name .. "_low"] then
      text[#text + 1] = ("%s %.4g (%.4g, %.4g)"):format(name, line[name], line[name .. "_low"], line[name .. "_high"])
    end
  end
  print(table.concat(text, ", "))
end

return alice
