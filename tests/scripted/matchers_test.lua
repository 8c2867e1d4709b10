-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The matchers themselves: each holds where it should and says what it saw where not.

-- Runs the expectation and wants it to fail with this text.
local function fails(text, body) expect(body):throws(text) end

describe("matchers about values", function()
  it("compare deeply", function()
    local ring, other = { 1 }, { 1 }
    ring.me, other.me = ring, other
    expect(ring):equals(other):never():is(other):is(ring)
    expect({ 1, { 2 } }):never():equals { 1, { 3 } }
    expect(0 / 0):equals(0 / 0)
    expect(1):equals(1.0)
    fails("[2].x: expected 2, got nil", function() expect({ 1, {} }):equals { 1, { x = 2 } } end)
    fails("an equal one but not the same", function() expect({}):is {} end)
  end)

  it("compare views of native numbers", function()
    local sim = meander.sim.new { world = meander.world.open "worlds/office.toml" }
    local sonar = sim.observation.sonar
    expect(sonar):equals(sonar:totable()):near(sonar:totable(), 0):has_length(16)
    fails("[3]", function()
      local other = sonar:totable()
      other[3] = -1
      expect(sonar):equals(other)
    end)
  end)

  it("know truth and absence", function()
    expect(true):is_true():is_truthy():exists():never():is_false()
    expect(false):is_false():is_falsy():never():is_nil()
    expect(nil):is_nil():is_falsy():never():exists()
    fails("expected true, got 1", function() expect(1):is_true() end)
  end)

  it("know kinds", function()
    expect(1):is_a("integer"):is_a("number"):never():is_a("float")
    expect(meander.world.new {}):is_a("world"):is_a("userdata")
    fails("expected a string, got 1", function() expect(1):is_a "string" end)
  end)

  it("compare sizes", function()
    expect(2):less_than(3):at_most(2):at_least(2):greater_than(1):between(2, 2)
    expect("a"):less_than "b"
    fails("expected less than 2, got 2", function() expect(2):less_than(2) end)
    fails("expected at least 1, got nil", function() expect(nil):at_least(1) end)
    fails("expected a number from 1 to 2, got", function() expect(0 / 0):between(1, 2) end)
    fails("a number or text expected, got nil", function() expect(1):less_than() end)
  end)

  it("compare with a tolerance", function()
    expect({ 1, { x = 2.01 } }):near({ 1, { x = 2 } }, 0.1)
    expect(1 / 0):near(1 / 0, 0)
    fails("off by 0.5", function() expect(1.5):near(1, 0.1) end)
    fails("expected 1 +- 1000000000.0", function() expect(0 / 0):near(1, 1e9) end)
    fails("[2]: expected 2", function() expect({ 1 }):near({ 1, 2 }, 0.1) end)
  end)

  it("look into texts and lists", function()
    expect("a.b"):contains("."):matches("^%a%.%a$"):never():contains("x"):has_length(3)
    expect({ "a", { 1 } }):contains("a"):contains({ 1 }):never():contains({ 2 })
    expect({}):is_empty()
    expect(""):is_empty()
    fails("contains", function() expect(nil):contains "x" end)
  end)

  it("see errors", function()
    local function boom() error "100% boom" end
    expect(boom):throws():throws("100% boom"):throws("b..m"):never():throws("bang")
    fails("expected an error, got none", function() expect(function() end):throws() end)
    fails("needed, got 3", function() expect(3):throws() end)
  end)

  it("take others", function()
    meander.testing.matcher("is_even", function(value) return value % 2 == 0, value .. " is odd" end)
    expect(2):is_even()
    expect(3).never:is_even()
    fails("3 is odd", function() expect(3):is_even() end)
    fails("exists already", function() meander.testing.matcher("equals", print) end)
    fails("a function(value, ...) expected", function() meander.testing.matcher("new", 3) end)
  end)
end)

describe("every matcher", function()
  local function text_of(path)
    local file <close> = assert(io.open(path))
    return file:read "a"
  end

  it("is in the manual and known to editors", function()
    local manual, stubs = text_of "docs/testing.md", text_of "lua/meta/testing.lua"
    for _, name in ipairs(meander.testing.matchers()) do
      expect(manual):matches("`" .. name .. "[(`]")
      expect(stubs):contains("---@field " .. name .. " ")
    end
  end)

  it("tell nan without a sign", function()
    for _, nan in ipairs { 0 / 0, -(0 / 0) } do
      expect(function() expect(nan):equals(1) end):throws "expected 1, got nan"
    end
  end)
end)
