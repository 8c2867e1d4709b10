-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
---@meta
-- What test files know besides meander, for editors. `tests/scripted/matchers_test.lua` holds it complete.

---@class test_options
---@field points? number  what passing the test is worth
---@field timeout? number  seconds that it may take

---Puts the tests that the body defines under one name; groups nest.
---@param name string
---@param options test_options
---@param body fun()
---@overload fun(name: string, body: fun())
function describe(name, options, body) end

---One test, in a process and Lua state of its own. Without a body it is left for later.
---@param name string
---@param options test_options
---@param body fun(seed: integer)
---@overload fun(name: string, body?: fun(seed: integer))
function it(name, options, body) end

---Runs before every test of the group and of the groups inside.
---@param body fun(seed: integer)
function before_each(body) end

---Runs after every test of the group and of the groups inside, also when it failed.
---@param body fun(seed: integer)
function after_each(body) end

---Beside tests: a test to come. Inside a test: ends it as skipped, with the reason.
---@param reason string
function pending(reason) end

---Begins an expectation about a value.
---@param value any
---@return expectation
function expect(value) end

---@class expectation
---@field never expectation | fun(self: expectation): expectation  turns the next matcher round
---@field equals fun(self: expectation, value: any): expectation  equal, tables deeply
---@field is fun(self: expectation, value: any): expectation  the very same
---@field is_true fun(self: expectation): expectation
---@field is_false fun(self: expectation): expectation
---@field is_nil fun(self: expectation): expectation
---@field exists fun(self: expectation): expectation  not nil
---@field is_truthy fun(self: expectation): expectation  neither nil nor false
---@field is_falsy fun(self: expectation): expectation  nil or false
---@field is_a fun(self: expectation, kind: string): expectation  "number", "integer", "run", ...
---@field near fun(self: expectation, value: number | table, tolerance?: number): expectation
---@field less_than fun(self: expectation, bound: number | string): expectation
---@field at_most fun(self: expectation, bound: number | string): expectation
---@field greater_than fun(self: expectation, bound: number | string): expectation
---@field at_least fun(self: expectation, bound: number | string): expectation
---@field between fun(self: expectation, low: number, high: number): expectation
---@field contains fun(self: expectation, part: any): expectation  a text or an element
---@field matches fun(self: expectation, pattern: string): expectation
---@field has_length fun(self: expectation, length: integer): expectation
---@field is_empty fun(self: expectation): expectation
---@field throws fun(self: expectation, text?: string): expectation  calling it fails
---@field reaches fun(self: expectation, place?: string | number | table | thing, tolerance?: number): expectation  of a run
---@field within fun(self: expectation, seconds: number): expectation  of a run: what was reached, by then
---@field touches_nothing fun(self: expectation): expectation  of a run or sim
---@field touches_nothing_by_its_fault fun(self: expectation): expectation  of a run or sim
---@field keeps fun(self: expectation, clearance: number): expectation  of a run [m]
---@field shorter_than fun(self: expectation, length: number): expectation  of a run [m]
---@field ends_because fun(self: expectation, words: string): expectation  of a run
---@field is_at fun(self: expectation, point: table, tolerance?: number): expectation  of a run or sim
---@field repeats fun(self: expectation, other?: run | sim | world): expectation  the same hash; of a function: twice the same
---@field has fun(self: expectation, name: string, count?: integer): expectation  of a world

---@class meander.testing
---@field seed integer  of math.random and of every test
---@field expect fun(value: any): expectation
local testing = {}

---Adds a matcher: judge(value, ...) returns whether it holds, and what to say when it does not.
---@param name string
---@param judge fun(value: any, ...): boolean, string?
function testing.matcher(name, judge) end

---The names of all matchers, sorted.
---@return string[]
function testing.matchers() end

return testing
