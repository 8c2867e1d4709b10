-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- "run", "world", "sim", ... for objects of meander, otherwise what type() says. Objects hide their metatables, but their
-- complaint about a member that no object has begins with the name of their kind.
return function(value)
  if type(value) ~= "userdata" then return type(value) end
  local _, complaint = pcall(function() return value.no_object_has_this end)
  return tostring(complaint):match("([%a_]+): has no member") or "userdata"
end
