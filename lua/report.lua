-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What every example prints at its end: a summary for people or one JSON object for tools, and where the pictures went.
local json = require "meander.json"

local report = {}

local drive_keys = { "example", "seed", "reached", "subgoals", "contacts", "time", "length", "clearance_min", "hash" }

local function leave(text, code)
  io.stderr:write((arg and arg[0] or "script"):match("[^/]*$"), ": ", text, "\n")
  os.exit(code, true)
end

--- Ends the script with one line on stderr and exit code 2: it was called in a way that cannot be meant.
function report.usage_error(text) leave(text, 2) end

--- Ends the script with one line on stderr and exit code 1: what was asked for cannot be done.
function report.failure(text) leave(text, 1) end

--- What a function returns; where it fails, `leave`, one of the two above, is told what is wrong, after `what` (optional)
--- and without the place in the code.
function report.try(leave_with, what, f, ...)
  local results = table.pack(pcall(f, ...))
  if results[1] then return table.unpack(results, 2, results.n) end
  leave_with((what and what .. ": " or "") .. tostring(results[2]):gsub("^[^:]*:%d+: ", ""))
end

--- The path of a file in the folder that --out names; the folder is made when it is not there.
function report.path(options, name)
  meander.make_folder(options.out)
  return options.out .. "/" .. name
end

-- Micrometres and microseconds are enough for a person and a table; the hash holds the rest.
local function rounded(value)
  return math.type(value) == "float" and tonumber(("%.6f"):format(value)) or value
end

--- Saves picture, table and record of a run as <out>/<example>.{svg,png,csv,jsonl}, then prints its summary. `more`
--- (optional) holds further keys for the JSON object.
function report.run(example, run, options, more)
  local stem = report.path(options, example)
  for _, suffix in ipairs { ".svg", ".png", ".csv", ".jsonl" } do run:save(stem .. suffix) end
  if not options.json then
    show(run)
    print(run)
    print("picture: " .. stem .. ".svg .png, table: " .. stem .. ".csv, record: " .. stem .. ".jsonl")
    return
  end
  local line, keys = { example = example }, table.move(drive_keys, 1, #drive_keys, 1, {})
  for i = 2, #keys do line[keys[i]] = rounded(run[keys[i]]) end
  line.reason, keys[#keys + 1] = run.reason, "reason"
  local extra = {}
  for key, value in pairs(more or {}) do
    line[key] = value
    extra[#extra + 1] = key
  end
  table.sort(extra)
  table.move(extra, 1, #extra, #keys + 1, keys)
  print(json.encode(line, keys))
end

return report
