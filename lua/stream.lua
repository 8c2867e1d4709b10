-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- stream(SEED): a function that gives numbers in [0, 1), the same for the same seed: what math.random has given before must
-- not matter to a made world.
--
--   local random = require "meander.stream"(7)
return function(seed)
  local state = (seed * 2654435761 + 88172645463325252) & 0x7fffffffffffffff
  return function()
    state = state ~ (state << 13)
    state = state ~ (state >> 7)
    state = state ~ (state << 17)
    return (state >> 11) / 9007199254740992.0
  end
end
