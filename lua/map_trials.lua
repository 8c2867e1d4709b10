-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The experiments of [CN] in one room: a robot that stands, turns, sees something appear and go away, and drives, while maps
-- of several sensor models see the same scans.
--
--   local trial = require("meander.map_trials").trial
--   local figures = trial({ models = { "nn4", "ros" }, wanted = { still = true }, places = 2 }, "real", 7)
local rooms = require "meander.sonar_rooms"

local trials = {}

--- The names of the experiments.
trials.experiments = { "direction", "robustness", "adaptability", "rotation", "fused", "still", "spread" }

local kScans = 15 -- of a robot that stands, as in the paper
local kStill = { 1, 10, 60 } -- scans after which the map of one that goes on standing is scored
local kTurn = math.pi / 16 -- half the pitch of 16 sonars: the worst there is; the paper's 66 degrees are nearly 3 pitches
local kMarked = 0.5
local kReach = 2.6 -- readings above this are no echo within the map [m]
local kAlike, kApart = 0.1, 0.5 -- readings of two neighbours that differ by less, by more than this [m]

-- A map of every model, all of which see the same scans.
local function maps_of(setting, preset, fusion)
  local maps = {}
  for _, model in ipairs(setting.models) do
    maps[model] = meander.mapping.map { model = model, preset = preset, fusion = fusion, global = false }
  end
  return maps
end

local function update(maps, observation)
  for _, map in pairs(maps) do map:update(observation) end
end

local function stand(sim, maps, scans)
  for _ = 1, scans do update(maps, sim:step(0, 0)) end
end

-- Adds figures to those of a model: lists of values, one per place.
local function note(results, experiment, fusion, model, figures)
  local key = table.concat({ experiment, fusion, model }, " ")
  results[key] = results[key] or {}
  for name, value in pairs(figures) do
    local list = results[key][name] or {}
    results[key][name] = list
    if value == value then list[#list + 1] = value end
  end
end

-- Share of the cells seen (where `truth` is not 0) whose class differs.
local function flipped(truth, before, after)
  local cells, changed = 0, 0
  for i = 1, #truth do
    if truth[i] > 0 then
      cells = cells + 1
      if (before[i] > kMarked) ~= (after[i] > kMarked) then changed = changed + 1 end
    end
  end
  return cells > 0 and changed / cells or 0 / 0
end

local function copies(maps)
  local matrices = {}
  for model, map in pairs(maps) do matrices[model] = map:matrix("local"):all() end
  return matrices
end

local function score_figures(score)
  return { error_cm = 100 * score.error, ce = score.ce, brier = score.brier, auc = score.auc, ece = score.ece }
end

-- One scan against many, and then a turn: the class of a cell should not change.
local function standing(setting, results, room, preset, seed, place)
  local maps = maps_of(setting, preset, "viewbin")
  local function sim_at(turn)
    local start = { place[1], place[2], place[3] + turn }
    return meander.sim.new { world = room.world, start = start, sonar = preset, seed = seed }
  end
  local sim = sim_at(0)
  stand(sim, maps, 1)
  local truth = meander.study.map_truth(maps[setting.models[1]], sim):all()
  local first = copies(maps)
  for _, model in ipairs(setting.models) do
    note(results, "robustness", "viewbin", model, score_figures(meander.study.map_score(maps[model], sim, { threshold = setting.thresholds[model] })))
  end
  stand(sim, maps, kScans - 1)
  local last = copies(maps)
  for _, model in ipairs(setting.models) do
    note(results, "robustness", "viewbin", model, { flipped = flipped(truth, first[model], last[model]) })
  end
  local turned = sim_at(kTurn)
  stand(turned, maps, kScans)
  local after = copies(maps)
  for _, model in ipairs(setting.models) do
    note(results, "rotation", "viewbin", model, { flipped = flipped(truth, last[model], after[model]) })
  end
end

-- How much of the front is marked.
local function marked(front, cells)
  local count = 0
  for _, i in ipairs(front) do
    if cells[i] > kMarked then count = count + 1 end
  end
  return count / #front
end

-- Scans until `done` holds for each model; one more than there were where it never does.
local function scans_until(setting, sim, maps, front, done)
  local scans = {}
  for scan = 1, kScans do
    stand(sim, maps, 1)
    for model, cells in pairs(copies(maps)) do
      if not scans[model] and done(marked(front, cells)) then scans[model] = scan end
    end
  end
  for _, model in ipairs(setting.models) do scans[model] = scans[model] or kScans + 1 end
  return scans
end

-- A pole appears near the robot and goes away again.
local function adaptability(setting, results, room, preset, seed, place)
  local maps = maps_of(setting, preset, "viewbin")
  local sim = meander.sim.new { world = room.world:fork(), start = place, sonar = preset, seed = seed }
  stand(sim, maps, kScans)
  local before = meander.study.map_truth(maps[setting.models[1]], sim):all()
  local bearing, distance = room.random(-math.pi, math.pi), room.random(0.6, 1.2)
  local radius = room.random(0.08, 0.2)
  local at = { place[1] + distance * math.cos(bearing), place[2] + distance * math.sin(bearing) }
  local clear = { world = sim.world, from = { place[1], place[2] }, heading = bearing, range = distance + radius + 0.2 }
  if meander.sensor.ray(clear) then return end
  local pole = sim.world:add_disc { center = at, radius = radius }
  stand(sim, maps, 1)
  local after, front = meander.study.map_truth(maps[setting.models[1]], sim):all(), {}
  for i = 1, #after do
    if after[i] == 2 and before[i] ~= 2 then front[#front + 1] = i end
  end
  if #front == 0 then return end
  local at_once = copies(maps)
  local half = scans_until(setting, sim, maps, front, function(share) return share >= 0.5 end)
  local there = copies(maps)
  sim.world:remove(pole)
  local clear_after = scans_until(setting, sim, maps, front, function(share) return share <= 0.1 end)
  for _, model in ipairs(setting.models) do
    local figures = { scans_to_half = marked(front, at_once[model]) >= 0.5 and 1 or half[model] + 1 }
    figures.first_update = marked(front, at_once[model])
    if marked(front, there[model]) >= 0.5 then figures.scans_to_clear = clear_after[model] end
    note(results, "adaptability", "viewbin", model, figures)
  end
end

-- Cells in sight whose probability is at a limit.
local function limited(truth, cells)
  local seen, at_limit = 0, 0
  for i = 1, #truth do
    if truth[i] > 0 then
      seen = seen + 1
      if cells[i] < 0.0101 or cells[i] > 0.9899 then at_limit = at_limit + 1 end
    end
  end
  return seen > 0 and at_limit / seen or 0 / 0
end

-- A robot that goes on standing learns nothing new; its map should not become surer.
local function still(setting, results, room, preset, seed, place)
  local both = { viewbin = maps_of(setting, preset, "viewbin"), bayes = maps_of(setting, preset, "bayes") }
  local sim = meander.sim.new { world = room.world, start = place, sonar = preset, seed = seed }
  local scans, truth = 0, nil
  for _, count in ipairs(kStill) do
    for _ = scans + 1, count do
      local observation = sim:step(0, 0)
      for _, maps in pairs(both) do update(maps, observation) end
    end
    scans = count
    if count == 1 then truth = meander.study.map_truth(both.viewbin[setting.models[1]], sim):all() end
    for fusion, maps in pairs(both) do
      local cells = copies(maps)
      for _, model in ipairs(setting.models) do
        note(results, "still", fusion, model, {
          ["ce_" .. count] = meander.study.map_score(maps[model], sim).ce,
          ["limited_" .. count] = limited(truth, cells[model]),
        })
      end
    end
  end
end

-- By how much the readings of the two sonars differ that point nearest the way of a cell [m].
local function difference(ranges, bearing)
  local u = bearing / (2 * math.pi) * #ranges
  local i = math.floor(u)
  local a, b = ranges[i % #ranges + 1], ranges[(i + 1) % #ranges + 1]
  return math.abs(math.min(a, kReach) - math.min(b, kReach))
end

-- Mean cross-entropy of some cells, both classes weighing the same; not a number where one is missing.
local function cross_entropy(truth, cells, some)
  local sum, count = { 0, 0 }, { 0, 0 }
  for _, i in ipairs(some) do
    local class = truth[i]
    sum[class] = sum[class] - math.log(class == 2 and cells[i] or 1 - cells[i])
    count[class] = count[class] + 1
  end
  return (sum[1] / count[1] + sum[2] / count[2]) / 2
end

-- What one scan tells of cells between sonars that read much the same, and between such that differ much.
local function spread(setting, results, room, preset, seed, place)
  local maps = maps_of(setting, preset, "viewbin")
  local sim = meander.sim.new { world = room.world, start = place, sonar = preset, seed = seed }
  stand(sim, maps, 1)
  local map, ranges = maps[setting.models[1]], sim.observation.sonar
  local truth, low, alike, apart = meander.study.map_truth(map, sim):all(), map:bounds("local")[1], {}, {}
  for i = 1, #truth do
    local x, y = (i - 1) % map.size + 0.5, (i - 1) // map.size + 0.5
    local bearing = math.atan(low.y + map.resolution * y - place[2], low.x + map.resolution * x - place[1]) - place[3]
    local differs = truth[i] > 0 and difference(ranges, bearing)
    if differs and differs < kAlike then alike[#alike + 1] = i end
    if differs and differs > kApart then apart[#apart + 1] = i end
  end
  for model, cells in pairs(copies(maps)) do
    local one, other = cross_entropy(truth, cells, alike), cross_entropy(truth, cells, apart)
    if one == one and other == other then
      note(results, "spread", "viewbin", model, { more = other - one, alike = one, apart = other })
    end
  end
end

-- The map at the end of a drive by both rules; every few seconds it is scored.
local function driving(setting, results, room, preset, seed)
  local both = { viewbin = maps_of(setting, preset, "viewbin"), bayes = maps_of(setting, preset, "bayes") }
  local subgoals = {}
  local start = room:place()
  for i = 1, 20 do
    local place = room:place()
    subgoals[i] = { place[1], place[2] }
  end
  local sim = meander.sim.new { world = room.world, start = start, sonar = preset, seed = seed }
  local cycles = 0
  sim:drive {
    navigator = "vfh_plus", subgoals = subgoals, when_trapped = "skip", time_limit = setting.drive, record_every = 0,
    on_step = function()
      cycles = cycles + 1
      for _, maps in pairs(both) do update(maps, sim.observation) end
      if cycles % 20 > 0 then return end
      for fusion, maps in pairs(both) do
        for _, model in ipairs(setting.models) do
          local score = meander.study.map_score(maps[model], sim, { threshold = setting.thresholds[model] })
          local figures = score_figures(score)
          note(results, "fused", fusion, model, figures)
          note(results, "direction", fusion, model,
            { error_cm = figures.error_cm, missed = score.missed, phantom = score.phantom })
          if fusion == "viewbin" then results.bins = results.bins or {} end
          if results.bins and fusion == "viewbin" then
            local bins = results.bins[model] or {}
            results.bins[model] = bins
            for k, bin in ipairs(score.reliability) do
              local sum = bins[k] or { 0, 0, 0 }
              bins[k] = { sum[1] + bin.weight, sum[2] + bin.predicted, sum[3] + bin.occupied }
            end
          end
        end
      end
    end,
  }
end

local function mean(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value end
  return #list > 0 and sum / #list or nil
end

--- A room's figures, one number each: the mean over its places or moments; and the sums of the reliability curves. The
--- setting: `models`; `wanted`, a set of experiments; `places`; `drive` [s]; `thresholds` by model.
function trials.trial(setting, preset, seed)
  local room, results, wanted = rooms.make(seed), {}, setting.wanted
  if wanted.robustness or wanted.rotation or wanted.adaptability or wanted.still or wanted.spread then
    for k = 1, setting.places do
      local place = room:place()
      if wanted.robustness or wanted.rotation then standing(setting, results, room, preset, 10 * seed + k, place) end
      if wanted.adaptability then adaptability(setting, results, room, preset, 10 * seed + k, place) end
      if wanted.still then still(setting, results, room, preset, 10 * seed + k, place) end
      if wanted.spread then spread(setting, results, room, preset, 10 * seed + k, place) end
    end
  end
  if wanted.direction or wanted.fused then driving(setting, results, room, preset, seed) end
  local bins = results.bins
  results.bins = nil
  local means = {}
  for key, figures in pairs(results) do
    means[key] = {}
    for name, list in pairs(figures) do means[key][name] = mean(list) end
  end
  return { means = means, bins = bins }
end

return trials
