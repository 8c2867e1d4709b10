-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The world changes while ALICE explores: a wall across the corridor is taken away after 3500 samples (Figure 2 of [Z]), or
-- one is put there. How soon is the gap linked, which links through the wall stay, and can the robot still drive? The
-- oracle knows the truth and cuts the links through the wall: nobody can forget better.
--
--   ./meander examples/alice_dynamic.lua --change added --forgetting all --seeds 20
local alice = require "meander.alice"
local candidates = require "meander.candidates"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "changes the world under a topologic map",
  { "--world NAMES", default = "alice_loop", help = "alice_loop, alice_rooms, with commas, or all" },
  { "--change NAMES", default = "removed", help = "removed, added, passing (put there, taken away half-way to the end), none, with commas, or all" },
  { "--forgetting NAMES", default = "doubt", help = "doubt (contacts suspend links), none, oracle, with commas, or all" },
  { "--explore NAMES", default = "any", help = "any (walls, straight on, few places), doubted (drives to doubted links, too), with commas, or all, which also tells the difference in pairs" },
  { "--samples N", default = 5000, least = 100, most = 1000000, help = "to gather" },
  { "--after N", default = 3500, least = 0, help = "samples until the wall comes or goes" },
  { "--goals N", default = 20, least = 0, most = 1000, help = "drives per seed at the end; 0: none" },
  { "--seeds N", default = 1, least = 1, most = 100000, help = "runs" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here; 1 to 999 are for tuning" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--json", help = "one JSON object per line instead of text" },
  { "--out DIR", default = "out", help = "folder for pictures before and after; none when empty" },
}
local most_after = math.min(options.samples, alice.first_moment(options)) - 1
if options.after > most_after then
  local goals = options.goals > 0 and (" and --goals %d, that the drives come after it"):format(options.goals) or ""
  report.usage_error(("--after: at most %d expected with --samples %d%s; got %d"):format(most_after, options.samples, goals, options.after))
end
local figures = {
  "gap_closed_after", "first_passage", "links_through_wall_left", "washed_out", "suspended_elsewhere", "contact_samples",
  "success", "false_arrivals",
  "suspended_by_wall", "came_back",
}
local kNear = 0.36 -- a contact this near to the gate is one with it [m]

-- The gate stands across x = its centre, from its lower to its upper end.
local function gate_of(world)
  local gate = world:get("gate")
  local half = gate.size[2] / 2
  return { x = gate.center[1], low = gate.center[2] - half, high = gate.center[2] + half }
end

local function crosses(gate, a, b)
  if (a.x - gate.x) * (b.x - gate.x) >= 0 then return false end
  local y = a.y + (gate.x - a.x) / (b.x - a.x) * (b.y - a.y)
  return y > gate.low - 0.15 and y < gate.high + 0.15
end

-- The links whose places truly lie on both sides of the gate.
local function through_gate(robot, gate)
  local found = {}
  for _, link in ipairs(robot.map.links) do
    local a = robot.scores:true_place(robot.map, link.a)
    local b = robot.scores:true_place(robot.map, link.b)
    if a and b and crosses(gate, a, b) then found[#found + 1] = link end
  end
  return found
end

local function trial(name, change, forgetting, explore, seed)
  local seen, moments, before = { contacts = 0 }, {}, nil
  local gate
  local blocked = {} -- links that were suspended when a passing wall went
  local function picture(robot, word)
    if options.out == "" or seed ~= options.first_seed then return end
    local stem = ("%s_%s_%s_%s.svg"):format(name, change, forgetting, word)
    meander.render.save(robot.map:over(robot.world), report.path(options, stem))
  end
  local function each(sample, robot)
    local pose = robot.sim.state.pose
    local here = { x = pose[1], y = pose[2] }
    if sample == options.after then
      picture(robot, "before")
      if change == "removed" then robot.sim.world:open("gate") end
      if change == "added" or change == "passing" then robot.sim.world:close("gate") end
    elseif sample > options.after then
      if not seen.passage and before and crosses(gate, before, here) then seen.passage = sample end
      if seen.passage and not seen.linked and change == "removed" and #through_gate(robot, gate) > 0 then
        seen.linked = sample
      end
      if change == "passing" and sample == (options.after + options.samples) // 2 then
        robot.sim.world:open("gate")
        for _, link in ipairs(through_gate(robot, gate)) do
          if link.suspended then blocked[#blocked + 1] = link end
        end
      end
      local touches = robot.sim.observation.whisker:max() > 0
      if touches and math.abs(here.x - gate.x) < kNear and here.y > gate.low and here.y < gate.high then
        seen.contacts = seen.contacts + 1
      end
    end
    before = here
    alice.keep_moment(moments, options, sample, robot)
  end
  local robot = alice.explore {
    world = name, seed = seed, samples = options.samples, each = each,
    wander = explore == "doubted" and { revisit = { share = 0.5 } } or nil,
    map = forgetting ~= "doubt" and { doubt = { suspend = 0 } } or nil,
    begin = function(world)
      gate = gate_of(world)
      if change == "removed" then world:close("gate") end
    end,
  }
  picture(robot, "after")
  local left, elsewhere = 0, 0
  local is_through = {}
  for _, link in ipairs(through_gate(robot, gate)) do
    is_through[link.a .. " " .. link.b] = true
    if not link.suspended then left = left + 1 end
  end
  for _, link in ipairs(robot.map.links) do
    if link.suspended and not is_through[link.a .. " " .. link.b] then elsewhere = elsewhere + 1 end
  end
  local result = {
    contact_samples = seen.contacts, suspended_elsewhere = elsewhere / #robot.map.links,
    first_passage = seen.passage and change == "removed" and seen.passage - options.after or nil,
    gap_closed_after = seen.linked and seen.passage and seen.linked - seen.passage or nil,
    links_through_wall_left = change == "added" and left or nil,
    washed_out = change == "added" and (left == 0 and 1 or 0) or nil,
  }
  if #blocked > 0 then
    local suspended, back = {}, 0
    for _, link in ipairs(robot.map.links) do suspended[link.a .. " " .. link.b] = link.suspended end
    for _, link in ipairs(blocked) do back = back + (suspended[link.a .. " " .. link.b] == false and 1 or 0) end
    result.came_back = back / #blocked
  end
  if change == "passing" then result.suspended_by_wall = #blocked end
  local arrived, wrongly = 0, 0
  for _, moment in ipairs(moments) do
    local start = { sim = moment.sim, map = moment.map, scores = robot.scores }
    if forgetting == "oracle" and change == "added" then
      for _, link in ipairs(through_gate(start, gate)) do moment.map:suspend(link.a, link.b) end
    end
    local there, wrong = alice.go(start, alice.goal(start))
    arrived, wrongly = arrived + (there and 1 or 0), wrongly + (wrong and 1 or 0)
  end
  if #moments > 0 then result.success, result.false_arrivals = arrived / #moments, wrongly / #moments end
  return result
end

-- What the second way to explore has more than the first, seed by seed.
local function paired(first, second)
  local differences = {}
  for i, trial in ipairs(second) do
    differences[i] = {}
    for _, figure in ipairs(figures) do
      if trial[figure] and first[i][figure] then differences[i][figure] = trial[figure] - first[i][figure] end
    end
  end
  return differences
end

local function line_of(words, explore, trials)
  local line = { table.unpack(words) }
  line[#line + 1] = { "explore", explore }
  line[#line + 1] = { "n", #trials }
  return line
end

local explorers = candidates.chosen(options.explore, { "any", "doubted" }, "way to explore")
for _, name in ipairs(candidates.chosen(options.world, { "alice_loop", "alice_rooms" }, "world")) do
  for _, change in ipairs(candidates.chosen(options.change, { "removed", "added", "passing", "none" }, "change")) do
    for _, forgetting in ipairs(candidates.chosen(options.forgetting, { "doubt", "none", "oracle" }, "rule of forgetting")) do
      local words = { { "world", name }, { "change", change }, { "forgetting", forgetting } }
      local by = {}
      for _, explore in ipairs(explorers) do
        by[explore] = alice.trials(options, function(seed) return trial(name, change, forgetting, explore, seed) end)
        alice.print(options, line_of(words, explore, by[explore]), by[explore], figures)
      end
      if by.any and by.doubted then
        local differences = paired(by.any, by.doubted)
        alice.print(options, line_of(words, "doubted - any", differences), differences, figures)
      end
    end
  end
end
