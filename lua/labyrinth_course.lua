-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A small robot that explores corridors of 1 m by sonar: shared by the examples that let one do so.
local course = {}

-- A disc of 0.2 m with the limits of a Nomad 200.
course.robot = {
  name = "nomad200", body = { radius = 0.2 }, sonar = { radius = 0.17 }, bumper = { radius = 0.2 },
}
-- `sonar`: cones that hear the nearest thing inside them, with the noise of a Nomad 200. `nomad`, `real`: walls that are
-- seen aslant are not heard; then silence says little.
course.sensors = { sonar = { incidence = false, corner_range = 0, firing = "simultaneous" }, nomad = "nomad", real = "real" }
course.silence = { sonar = 3, nomad = 0.8, real = 0.8 }

-- The options of an explorer on this robot; `options` are added to them.
function course.explorer(options)
  local all = { robot = course.robot, map = { silence = course.silence[options.sensor or "sonar"] } }
  for name, value in pairs(options) do
    if name ~= "sensor" then all[name] = value end
  end
  return all
end

-- One run: {world, explorer, seed, sensor, navigator, drift, start, limit} gives the run, and where the robot truly ended.
function course.run(task)
  local sim = meander.sim.new {
    world = task.world, robot = course.robot, sonar = course.sensors[task.sensor or "sonar"], seed = task.seed,
    drift = task.drift, start = task.start,
  }
  local run = sim:drive {
    navigator = task.navigator or meander.polar.navigator { robot = course.robot },
    guide = task.explorer:guide(), time_limit = task.limit or 3000, record_every = 0,
  }
  return run, sim
end

return course
