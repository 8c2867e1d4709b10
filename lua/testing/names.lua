-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The nearest of several names to one that was misspelt.

-- Insertions, deletions and substitutions between two texts.
local function distance(a, b)
  local above = {}
  for j = 0, #b do above[j] = j end
  for i = 1, #a do
    local row = { [0] = i }
    for j = 1, #b do
      local same = a:byte(i) == b:byte(j)
      row[j] = math.min(above[j] + 1, row[j - 1] + 1, above[j - 1] + (same and 0 or 1))
    end
    above = row
  end
  return above[#b]
end

--- "; did you mean 'equals'?" or an empty text. A name that begins like another one counts as near.
return function(name, names)
  local best, least = nil, math.max(1, #name // 3) + 1
  for _, candidate in ipairs(names) do
    local steps = distance(name, candidate)
    if #name >= 3 and candidate:find(name, 1, true) then steps = math.min(steps, 1) end
    if steps < least then best, least = candidate, steps end
  end
  return best and ("; did you mean '%s'?"):format(best) or ""
end
