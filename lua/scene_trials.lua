-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Drives of navigators through the scenes of meander.scenes, over many seeds:
--
--   local trials = require "meander.scene_trials"
--   local runs = trials.over("u_trap", "polar", { count = 20, first_seed = 1, jobs = 0 }, { drift = 0.05 })
local scenes = require "meander.scenes"

local trials = {}

-- Models of the sonars by name, in the order in which they are told.
local models = {
  ideal = "ideal", nomad = "nomad", real = "real",
  crosstalk = { preset = "real", crosstalk = true, fired_together = 2 },
}
trials.sonars = { "ideal", "nomad", "real", "crosstalk" }

-- Dead reckoning tells ways and turns too long or too short by these shares; the seed says which.
local function drift(ways, turns, seed)
  return { distance_bias = (seed % 2 == 0 and 1 or -1) * ways, turn_bias = (seed % 4 < 2 and 1 or -1) * turns }
end

--- Figures of one run; nothing but `passed_over`, the reason, where the seed has no such scene. `setting`: `sonar`,
--- one of trials.sonars; `drift` and `turn_drift`, shares of ways and turns; `jitter` of the control period, a share;
--- `delay` of commands, in cycles; `hand_over` [m] and `time_limit` [s] instead of the scene's own; `picture`, a file to save.
function trials.drive(name, navigator, seed, setting)
  local scene, why = scenes.make(name, seed)
  if not scene then return { passed_over = why } end
  local sim = meander.sim.new {
    world = scene.world, start = scene.start, robot = "nomad200", sonar = models[setting.sonar or "nomad"], seed = seed,
    period_jitter = setting.jitter or 0, command_delay = setting.delay or 0,
    drift = drift(setting.drift or 0, setting.turn_drift or 0, seed),
  }
  local run = sim:drive {
    navigator = navigator, subgoals = scene.subgoals, hand_over = setting.hand_over or scene.hand_over,
    when_trapped = "insist", time_limit = setting.time_limit or scene.time_limit, record_every = setting.picture and 1 or 0,
  }
  if setting.picture then run:save(setting.picture) end
  return {
    success = run.success, contacts = run.contacts, fault_contacts = run.fault_contacts, trapped = run.trapped,
    time = run.time, length = run.length, clearance = run.clearance_min, cycle_us = 1e6 * run.cpu_per_cycle,
    picture = setting.picture,
  }
end

--- Runs of `count` seeds from `first_seed` on that have the scene; at most ten times as many are looked at. Returns
--- the runs and how many seeds were looked at. `navigator` is a name or a function that makes one; `out` in `which`
--- (optional) is a function that names the picture of a seed.
function trials.over(name, navigator, which, setting)
  local runs, seed = {}, which.first_seed
  local last = seed + 10 * which.count
  while #runs < which.count and seed < last do
    local seeds = {}
    for i = 1, which.count - #runs do seeds[i], seed = seed, seed + 1 end
    local results = meander.study.trials { seeds = seeds, jobs = which.jobs, trial = function(s)
      local own = setmetatable({ picture = which.out and which.out(s) }, { __index = setting })
      return trials.drive(name, type(navigator) == "function" and navigator() or navigator, s, own)
    end }
    for _, result in ipairs(results) do
      if not result.ok then error(("%s, seed %d: %s"):format(name, result.seed, result.error), 0) end
      if not result.value.passed_over then runs[#runs + 1] = result.value end
    end
  end
  return runs, seed - which.first_seed
end

return trials
