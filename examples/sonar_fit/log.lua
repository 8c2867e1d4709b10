-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Recorded sonar: a CSV file with one row per frame, the ranges [m] of all sensors first; a heading row and further
-- columns (labels, times) are passed over. This is the form of UCI data set 194 (SCITOS G5).
local log = {}

local function ranges_of(line)
  local ranges = {}
  for word in line:gmatch "[^,;%s]+" do
    local value = tonumber(word)
    if not value then break end
    ranges[#ranges + 1] = value
  end
  return ranges
end

--- Frames of the file (lists of ranges of equal length) and how many lines were passed over, or nil and why not.
function log.read(path)
  local frames, passed, number = {}, 0, 0
  local file, problem = io.open(path)
  if not file then return nil, problem end
  for line in file:lines() do
    number = number + 1
    local ranges = ranges_of(line)
    if #ranges < 2 then
      passed = passed + 1
    elseif frames[1] and #ranges ~= #frames[1] then
      return nil, ("%s:%d: %d ranges expected as in the rows above, got %d"):format(path, number, #frames[1], #ranges)
    else
      frames[#frames + 1] = ranges
    end
  end
  file:close()
  if #frames < 10 then return nil, ("%s: at least 10 rows of ranges expected, got %d"):format(path, #frames) end
  return frames, passed
end

--- What the sensors say when nothing echoes: the value that occurs most often.
function log.no_echo(frames)
  local count, best = {}, nil
  for _, frame in ipairs(frames) do
    for _, range in ipairs(frame) do
      count[range] = (count[range] or 0) + 1
      local more = not best or count[range] > count[best]
      if more or (count[range] == count[best] and range > best) then best = range end
    end
  end
  return best
end

return log
