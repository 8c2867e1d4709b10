-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What a run of sonar readings looks like in seventeen numbers. None of them needs to know where the robot was.
local statistics = {}

--- Names in the order of the tables, each with the difference that counts as one unit of misfit.
statistics.list = {
  { "max_share", 0.01, "readings at the maximum" },
  { "jump_05", 0.01, "changes from frame to frame over 0.5 m" },
  { "jump_02", 0.01, "changes over 0.2 m" },
  { "jump_005", 0.02, "changes over 0.05 m" },
  { "glitch", 0.005, "single frames off by over 0.5 m, back within 0.1 m" },
  { "glitch_short", 0.005, "of these, too short" },
  { "glitch_max", 0.005, "of these, at the maximum" },
  { "max_run", 2.0, "mean length of runs at the maximum, in frames" },
  { "max_run_one", 0.10, "share of these runs that last one frame" },
  { "jump_max", 0.10, "jumps over 0.5 m that start or end at the maximum" },
  { "near_002", 0.10, "neighbours that agree within 2 cm" },
  { "near_05", 0.10, "neighbours over 0.5 m apart" },
  { "near_1", 0.10, "neighbours over 1 m apart" },
  { "still_001", 0.10, "changes of at most 1 cm" },
  { "still_0", 0.10, "changes of exactly 0" },
}

local kBin = 0.25

-- Changes of one sensor over time.
local function count_changes(frames, sensor, top, c)
  local before, run = nil, 0
  for t = 1, #frames do
    local r = frames[t][sensor]
    local at_max = r >= top
    if before then
      local change = math.abs(r - before)
      c.changes = c.changes + 1
      if change > 0.5 then
        c.jump_05 = c.jump_05 + 1
        if at_max or before >= top then c.jump_max = c.jump_max + 1 end
      end
      if change > 0.2 then c.jump_02 = c.jump_02 + 1 end
      if change > 0.05 then c.jump_005 = c.jump_005 + 1 end
      if change <= 0.01 + 1e-9 then c.still_001 = c.still_001 + 1 end
      if change == 0 then c.still_0 = c.still_0 + 1 end
    end
    if at_max then
      run = run + 1
    elseif run > 0 then
      c.runs, c.run_frames, c.runs_one, run = c.runs + 1, c.run_frames + run, c.runs_one + (run == 1 and 1 or 0), 0
    end
    before = r
  end
  if run > 0 then c.runs, c.run_frames, c.runs_one = c.runs + 1, c.run_frames + run, c.runs_one + (run == 1 and 1 or 0) end
end

local function count_glitches(frames, sensor, top, c)
  for t = 2, #frames - 1 do
    local a, b, d = frames[t - 1][sensor], frames[t][sensor], frames[t + 1][sensor]
    if math.abs(b - a) > 0.5 and math.abs(d - a) < 0.1 then
      c.glitch = c.glitch + 1
      if b >= top then
        c.glitch_max = c.glitch_max + 1
      elseif b < a then
        c.glitch_short = c.glitch_short + 1
      end
    end
  end
end

local function count_neighbours(frames, c)
  local n = #frames[1]
  for _, frame in ipairs(frames) do
    for i = 1, n do
      local difference = math.abs(frame[i] - frame[i % n + 1])
      if difference < 0.02 then c.near_002 = c.near_002 + 1 end
      if difference > 0.5 then c.near_05 = c.near_05 + 1 end
      if difference > 1 then c.near_1 = c.near_1 + 1 end
    end
  end
end

local function histogram(frames, top, bins)
  local h, share = {}, 1 / (#frames * #frames[1])
  for i = 1, bins + 1 do h[i] = 0 end
  for _, frame in ipairs(frames) do
    for _, r in ipairs(frame) do
      local bin = r >= top and bins + 1 or math.min(bins, math.floor(r / kBin) + 1)
      h[bin] = h[bin] + share
    end
  end
  return h
end

--- All statistics of the frames, with their histogram of ranges (0.25 m bins and one for the maximum).
function statistics.of(frames, range_max)
  local top = range_max - 0.01
  local c = setmetatable({}, { __index = function() return 0 end })
  for sensor = 1, #frames[1] do
    count_changes(frames, sensor, top, c)
    count_glitches(frames, sensor, top, c)
  end
  count_neighbours(frames, c)
  local readings = #frames * #frames[1]
  local h = histogram(frames, top, math.ceil(range_max / kBin))
  local result = { histogram = h, max_share = h[#h] }
  for _, key in ipairs { "jump_05", "jump_02", "jump_005", "glitch", "glitch_short", "glitch_max", "still_001", "still_0" } do
    result[key] = c[key] / c.changes
  end
  for _, key in ipairs { "near_002", "near_05", "near_1" } do result[key] = c[key] / readings end
  result.max_run = c.runs > 0 and c.run_frames / c.runs or 0
  result.max_run_one = c.runs > 0 and c.runs_one / c.runs or 0
  result.jump_max = c.jump_05 > 0 and c.jump_max / c.jump_05 or 0
  return result
end

--- Total variation between two histograms: 0 the same, 1 nothing in common.
function statistics.distance(a, b)
  local sum = 0
  for i = 1, math.max(#a.histogram, #b.histogram) do
    sum = sum + math.abs((a.histogram[i] or 0) - (b.histogram[i] or 0))
  end
  return 0.5 * sum
end

--- Misfit: mean of the differences in their units, and eight times the distance of the histograms.
function statistics.misfit(a, b)
  local sum = 0
  for _, entry in ipairs(statistics.list) do sum = sum + math.abs(a[entry[1]] - b[entry[1]]) / entry[2] end
  return sum / #statistics.list + 8 * statistics.distance(a, b)
end

return statistics
