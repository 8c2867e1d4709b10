-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Differential evolution (Storn and Price 1997, rand/1/bin) over the sonar's parameters, evaluated in worker processes.
local search = {}

--- What is fitted: name, least and largest value. The last three belong to the recording, not to the sonar.
search.parameters = {
  { "half_cone", math.rad(6), math.rad(25) },
  { "incidence_limit", math.rad(10), math.rad(50) },
  { "incidence_jitter", 0, math.rad(15) },
  { "jitter_hold", 1, 25 },
  { "corner_range", 0, 3 },
  { "noise", 0.0002, 0.02 },
  { "noise_proportional", 0, 0.01 },
  { "dropout", 0, 0.03 },
  { "spurious", 0, 0.06 },
  { "repeat", 0, 0.12 },
  { "ring", 0.2, 0.4 },
  { "distance", 0.35, 0.7 },
  { "speed", 0.06, 0.4 },
}

--- Leaves the sonar as it is and fits the recording's own parameters only: ring, distance, speed.
function search.only_the_drive()
  search.parameters = table.move(search.parameters, #search.parameters - 2, #search.parameters, 1, {})
end

local function clamped(value, p) return math.max(p[2], math.min(p[3], value)) end

--- A point drawn around `center`, each parameter within a quarter of its range.
function search.near(center, random)
  local point = setmetatable({}, { __index = center })
  for _, p in ipairs(search.parameters) do
    point[p[1]] = clamped(center[p[1]] + 0.5 * (random() - 0.5) * (p[3] - p[2]), p)
  end
  return point
end

-- A mutant of the member from three others, crossed with it.
local function child(population, i, random)
  local function other() return population[math.floor(random() * #population) + 1].point end
  local a, b, c, forced = other(), other(), other(), math.floor(random() * #search.parameters) + 1
  local point = setmetatable({}, { __index = population[i].point })
  for k, p in ipairs(search.parameters) do
    local name = p[1]
    local cross = k == forced or random() < 0.7
    point[name] = cross and clamped(a[name] + 0.6 * (b[name] - c[name]), p) or population[i].point[name]
  end
  return point
end

-- The misfits of points, in their order.
local function evaluate(points, misfit, jobs)
  local seeds, list = {}, {}
  for i = 1, #points do seeds[i] = i end
  local results = meander.study.trials { seeds = seeds, jobs = jobs, trial = function(i) return misfit(points[i]) end }
  for i, result in ipairs(results) do list[i] = result.ok and result.value or math.huge end
  return list
end

--- Improves `start` (a list of points) for `generations`; returns the best point and its misfit. `tell` hears of each
--- generation. Same arguments, same result, whatever the number of jobs.
function search.evolve(start, generations, misfit, random, jobs, tell)
  local population, values = {}, evaluate(start, misfit, jobs)
  for i, point in ipairs(start) do population[i] = { point = point, misfit = values[i] } end
  for generation = 1, generations do
    local children = {}
    for i = 1, #population do children[i] = child(population, i, random) end
    values = evaluate(children, misfit, jobs)
    for i, point in ipairs(children) do
      if values[i] < population[i].misfit then population[i] = { point = point, misfit = values[i] } end
    end
    local best = math.huge
    for _, member in ipairs(population) do best = math.min(best, member.misfit) end
    tell(generation, best)
  end
  table.sort(population, function(a, b) return a.misfit < b.misfit end)
  return population[1].point, population[1].misfit
end

return search
