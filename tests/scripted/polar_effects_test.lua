-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Effects of the polar navigator's parts that are large enough to be seen in a few drives. Others are not measurable in so
-- few, and not asserted: docs/polar.md has them with their intervals.
local trials = require "meander.scene_trials"

-- Median time of those that arrive, and how many do.
local function drives(scene, setting, options)
  options.robot = "nomad200"
  local times, arrived = {}, 0
  for seed = 1, 5 do
    local run = trials.drive(scene, meander.polar.navigator(options), seed, setting)
    times[#times + 1] = run.time
    arrived = arrived + (run.success and 1 or 0)
  end
  return (meander.study.median(times)), arrived
end

describe("the polar navigator", function()
  it("needs its prediction when commands are a cycle late", function()
    local with, all = drives("four_targets", { delay = 1 }, {})
    local without = drives("four_targets", { delay = 1 }, { prediction = { enabled = false } })
    expect(all):equals(5)
    expect(without / with):greater_than(1.4)
  end)

  it("gets around the U later with one scan remembered than with ten", function()
    local ten = drives("u_trap", {}, { trap = { watch = false } })
    local one = drives("u_trap", {}, { trap = { watch = false }, memory = { scans = 1 } })
    expect(one / ten):greater_than(1.15)
  end)

  it("leaves the large U only with its remedies", function()
    local _, with = drives("large_u", {}, {})
    local _, without = drives("large_u", {}, { mode = "paper" })
    expect(with):equals(5)
    expect(without):equals(0)
  end)

  it("is slower in the paper's mode", function()
    local full = drives("l_corner", {}, {})
    local paper = drives("l_corner", {}, { mode = "paper" })
    expect(paper / full):greater_than(1.3)
  end)
end)
