-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
---@meta meander
-- What scripts see of meander, for the Lua language server. Written by `meander doc --write`; changes here are lost.

---A point; results have [1], [2] and x, y, arguments may have either.
---@class meander.point
---@field x? number [m]
---@field y? number [m]
---@field [integer] number

---A pose; as a point, with [3] or heading.
---@class meander.pose: meander.point
---@field heading? number [rad]

---Lower left and upper right corner.
---@alias meander.box meander.point[]

---@class meander.size
---@field width? number [m]
---@field height? number [m]
---@field [integer] number

---The truth: walls, doors, movers, lights and named places. Every edit can be undone.
---@class world
---@field title string Its name.
---@field note string What it shows, and its source.
---@field bounds meander.box Lower left and upper right corner. [m]
---@field start meander.pose|nil Where robots start, nil when it is not said. [m, rad]
local world = {}

---A thing in a world. Its handle stays the same when it is moved, renamed, or removed and brought back. In another world, such as a fork, it means the thing of the same number and name; if there is none, that is an error.
---@class thing
---@field name string Its name.
---@field kind string 'obstacle', 'door', 'mover', 'light' or 'place'.
---@field number integer Its number in the order of adding.
---@field alive boolean Is it in the world? False after it was removed, true again after undo.
---@field world world The world it is in.
local thing = {}

---A view of native numbers: [i], #, ipairs. It copies nothing and keeps what it shows alive.
---@class numbers
---@field [integer] number|nil
local numbers = {}

---Rows of native numbers: m[i] is a view of row i, #m their number.
---@class matrix
---@field [integer] numbers|nil
---@field rows integer How many rows.
---@field columns integer How many columns.
local matrix = {}

---All that the robot side gets to see in a control cycle: sonar, bumpers, whiskers, light, odometry.
---@class observation
---@field time number Time since the start. [s]
---@field period number Length of the cycle that ends here. [s]
---@field pose meander.pose Where the odometry says it is. [m, rad]
---@field v number Forward speed. [m/s]
---@field w number Turning rate. [rad/s]
---@field vy number Speed to the left; 0 for unicycles. [m/s]
---@field sonar numbers Ranges in ring order, the first forward, counter-clockwise; the largest range: no echo. [m]
---@field sonar_poses meander.pose[] Odometry pose of the robot at which each range was taken. [m, rad]
---@field bumper numbers Bumpers in ring order; 1: pressed.
---@field whisker numbers Whiskers in ring order; 1: bent.
---@field light numbers Light sensors in ring order: brightness, compressed by the logarithm.
---@field bumped boolean Is any bumper pressed?
local observation = {}

---The truth about a robot of a simulation, for scores and pictures.
---@class robot
---@field number integer Which robot, 1 first.
---@field platform string What kind of robot it is.
---@field radius number Radius of its body. [m]
---@field pose meander.pose Its true pose. [m, rad]
---@field v number Its true forward speed. [m/s]
---@field w number Its true turning rate. [rad/s]
---@field vy number Its true speed to the left; 0 for unicycles. [m/s]
---@field touching boolean Was it in contact at the end of the cycle?
---@field contacts integer Contacts so far.
---@field fault_contacts integer Contacts by its own motion so far.
---@field travelled number Its way so far. [m]
---@field clearance number From its hull to the nearest obstacle, 10 at most. [m]
---@field observation observation What it sees and its odometry says.
local robot = {}

---Drives towards one subgoal by readings and odometry alone.
---@class navigator
---@field name string Its name.
local navigator = {}

---Says where to go next.
---@class guide
---@field name string Its name.
local guide = {}

---A simulation: a world, its robots, a clock.
---@class sim
---@field time number Time since the start. [s]
---@field period number Length of a control cycle. [s]
---@field seed integer Seed of all random streams.
---@field world world The world it runs in.
---@field observation observation What the first robot sees and its odometry says.
---@field pose meander.pose True pose of the first robot. [m, rad]
---@field state robot The truth about the first robot.
---@field robots robot[] The truth about every robot.
local sim = {}

---Something drawn: show() shows it, meander.render.save writes it.
---@class picture
local picture = {}

---How a drive went: figures, traces, a picture.
---@class run
---@field reached integer Subgoals reached.
---@field subgoals integer Subgoals in all; 0: unknown.
---@field success boolean Did the guide finish and say that the task is done?
---@field reason string Why it ended, in words.
---@field contacts integer How often it touched something.
---@field fault_contacts integer Contacts by its own motion.
---@field trapped integer How often the navigator said that it is trapped.
---@field seed integer Seed of the simulation.
---@field hash string Hash of every state of the run, 16 hexadecimal digits.
---@field navigator string Who drove.
---@field guide string Who said where to.
---@field goals ({ x?: number, y?: number, tolerance?: any, heading?: any, name?: any, [integer]: number })[] The subgoals in the order they were given. [m]
---@field world world A copy of the world as it was at the end.
---@field time number How long it took. [s]
---@field length number The true way. [m]
---@field clearance_min number Least distance from the hull to an obstacle. [m]
---@field clearance_mean number Mean distance from the hull to the nearest obstacle. [m]
---@field turning number Sum of all changes of heading. [rad]
---@field jerk number Mean change of acceleration; small is smooth. [m/s^3]
---@field cpu_per_cycle number Computing time of guide and navigator per cycle. [s]
---@field cycles integer Control cycles.
---@field steps integer Recorded cycles: the length of its traces.
local run = {}

---One scan of a sonar ring.
---@class reading
---@field ranges numbers Ranges in ring order, the first forward, counter-clockwise. [m]
---@field range_max number The range that stands for no echo. [m]
---@field pose meander.pose Where the robot stood. [m, rad]
---@field transducers meander.pose[] Where the sonars were. [m, rad]
local reading = {}

---A local grid map that slides with the robot, and the map of everywhere that it feeds.
---@class map
---@field model string Name of its sensor model.
---@field fusion string 'viewbin' or 'bayes'.
---@field scans integer How many it has taken in.
---@field size integer Cells along a side of the window.
---@field resolution number Side of a cell. [m]
local map = {}

---A sensor model: what one scan tells about cells.
---@class sonar_model
---@field name string Its name.
---@field reach number It says nothing about cells farther away. [m]
local sonar_model = {}

---A network that reads a sonar ring.
---@class sonar_network
---@field name string What it is told about a cell, by its name.
---@field layers integer[] Units of each layer, the inputs first.
---@field sonar string The sonar that it was trained for, in words.
---@field made_by string What made it, with the seed, in words.
local sonar_network = {}

---Scans with cells around the robot whose truth is known.
---@class lessons
---@field scans integer How many.
local lessons = {}

---Recorded scans of a robot: log[i] is an observation, #log their number.
---@class sonar_log
---@field [integer] observation|nil
---@field report table What was met in the file: table of counts.
---@field ring table|nil Where the sonars sit, as the option sonar of a robot; nil when the file does not tell. [m, rad]
---@field sonars integer Ranges in a scan.
local sonar_log = {}

---A map of cells to plan on.
---@class grid_map
---@field width integer Cells along x.
---@field height integer Cells along y.
---@field resolution number Side of a cell. [m]
local grid_map = {}

---A path, and the landscape that it was found on.
---@class plan
---@field path meander.point[] The points of the path, from the start's cell to the target's. [m]
---@field measures table What the path is like: length, turning, curvature, clearance.
---@field statistics table What the planner did: cells, relaxations, dead_units, residual, solver.
---@field clear boolean For certain the whole path keeps the robot's body clear of all that is solid.
---@field planner string Who planned it.
local plan = {}

---A neural map that follows the edits of its map.
---@class replanner
---@field relaxations number Updates of a cell's value that the last replan needed; before it, the first solve.
local replanner = {}

---Indicators and the links between their ports.
---@class indicator_graph
---@field indicators indicator[] All of them, in the order of their serial numbers.
---@field links table[] All of them: {a, a_port, b, b_port, length}.
---@field ways table[] The links between crossings and ends, stops in corridors left out: {a, b, length, between}.
---@field source string It as text, a line each.
local indicator_graph = {}

---An indicator of a graph: a place with motion directions.
---@class indicator
---@field position meander.point Where it is. [m]
---@field serial integer Its serial number.
---@field alive boolean Is it in the graph?
---@field ports table[] Its motion directions: {direction, reach, state, to, to_port, length}.
local indicator = {}

---Decides where to go, and remembers the way as a graph of indicators.
---@class explorer
---@field state table Where it is in its work: {run, decisions, walked, at, start, at_goal, reopened, proven}.
---@field goal meander.point Where to. [m]
---@field options table Its options, as they were given or left out.
local explorer = {}

---Explores with indicators by sonar.
---@class sonar_explorer
---@field ending 'driving'|'reached'|'no_passable_direction'|'trapped'|'budget' 'driving', or how the last run ended: 'reached', 'no_passable_direction', 'trapped', 'budget'. A drive that is cut off leaves it at 'driving'.
---@field reason string Why it ended, in words.
---@field walked number Driven in this run. [m]
---@field decisions integer Taken in all runs.
---@field blocked integer Ways on which it did not get through in this run.
---@field second_looks integer How often in this run it had no port left and looked again before it gave the goal up.
---@field proven boolean Nothing unknown can shorten the route by more than eps.
local sonar_explorer = {}

---Cells of 1 m with or without walls between them.
---@class labyrinth
---@field columns integer Cells along x.
---@field rows integer Cells along y.
---@field start meander.point Centre of the first cell. [m]
---@field goal meander.point Centre of the last cell. [m]
local labyrinth = {}

---Keeps to the shortest way over cells by all that it has seen of them.
---@class cell_planner
---@field proven boolean The last run was as short as it can be.
local cell_planner = {}

---Places with what was sensed there, linked where the robot went from one to the other.
---@class topologic_map
---@field places table[] All places: {number, serial, position, born, hits, links}.
---@field links table[] All links: {a, b, weight, doubt, suspended}.
---@field winner integer|nil Number of the place that won last; nil: none yet.
---@field pose meander.pose Where the robot believes to be, in the frame of the map. [m, rad]
---@field samples integer Samples so far.
---@field source string It as text, as save writes it.
local topologic_map = {}

---Places that tell by links which of a few lights and touches is theirs.
---@class minimal_map
local minimal_map = {}

---How well a robot that builds a map of places knows where it is.
---@class place_scores
local place_scores = {}

---A laboratory for sonar navigation.
meander = {}

---Makes a folder, and those above it, where they are missing.
---
---Fails on a file is in the way; no permission.
---
---```lua
---meander.make_folder(os.tmpname():match('^(.*)/'))
---```
---@param path string the folder
function meander.make_folder(path) end

---The folder of the worlds and examples that came with the program; files that are not found here are looked for there.
---
---```lua
---print(meander.data_folder())
---```
---@return string|nil # its path, nil when there is none
function meander.data_folder() end

---The names of the things in the order they were added.
---
---```lua
---print(#meander.world.open('worlds/office.toml'):names 'door*')
---```
---@param pattern? string only names that fit it: * any run of characters, ? one character
---@return string[] # list of names
function world:names(pattern) end

---Handles of the things in the order they were added.
---
---```lua
---for _, t in ipairs(meander.world.open('worlds/office.toml'):things()) do print(t) end
---```
---@param pattern? string only names that fit it: * any run of characters, ? one character
---@return thing[] # list of things
function world:things(pattern) end

---Handles of the obstacles in the order they were added.
---
---```lua
---print(#meander.world.open('worlds/office.toml'):obstacles())
---```
---@return thing[] # list of things
function world:obstacles() end

---Handles of the named places in the order they were added.
---
---```lua
---print(meander.world.open('worlds/office.toml'):places()[1].name)
---```
---@return thing[] # list of things
function world:places() end

---The handle of a thing.
---
---Fails on no such name.
---
---```lua
---print(meander.world.open('worlds/office.toml'):thing 'hall')
---```
---@param name thing|string its name
---@return thing # the thing
function world:thing(name) end

---Everything about a thing, under the keys that add and replace take.
---
---Fails on no such thing.
---
---```lua
---print(meander.world.open('worlds/office.toml'):get('hall').position)
---```
---@param thing thing|string the thing or its name
---@return table # table with kind, name, shape and the rest
function world:get(thing) end

---An independent copy, with its own history of edits.
---
---```lua
---w = meander.world.new {}
---v = w:fork()
---print(v == w)
---```
---@return world # the copy
function world:fork() end

---What turns this world into another, one line each.
---
---```lua
---w = meander.world.new {}
---print(#w:diff(w:fork()))
---```
---@param other world the other world
---@return string[] # list of lines, empty for equal worlds
function world:diff(other) end

---A Lua script that builds this world with all its undo steps.
---
---```lua
---print(meander.world.new { title = 'empty' }:log())
---```
---@return string # the script
function world:log() end

---The text of the world file: equal worlds give equal texts.
---
---```lua
---print(meander.world.new { title = 'empty' }:to_toml())
---```
---@return string # TOML text
function world:to_toml() end

---Hash of everything that stands, not of the history.
---
---```lua
---print(meander.world.new {}:hash())
---```
---@return string # 16 hexadecimal digits
function world:hash() end

---Writes the world (.toml) or its picture (.svg, .png), at once or not at all.
---
---Fails on unknown suffix; the file cannot be written.
---
---```lua
---meander.world.new {}:save(os.tmpname() .. '.toml')
---```
---@param path string the suffix says what is written
function world:save(path) end

---@class world.add_wall.options
---@field points meander.point[] corners of the wall, at least two [m]
---@field closed? boolean joins the last point to the first; false when left out
---@field name? string its name; "kind number" when left out
---@field echo? number strength of the echo; 1 when left out
---@field specular_limit? number largest angle to the normal that echoes; the sonar's own when left out [rad]

---Adds a thin wall through points.
---
---Fails on bad shape or number; name taken; ground needed by the start or a place.
---
---```lua
---meander.world.new {}:add_wall { points = {{2, 2}, {4, 2}, {4, 3}} }
---```
---@param options world.add_wall.options its points and more
---@return thing # the new thing
function world:add_wall(options) end

---@class world.add_polygon.options
---@field outer meander.point[] corners of the rim, at least three [m]
---@field holes? meander.point[][] rims of free areas inside [m]
---@field name? string its name; "kind number" when left out
---@field echo? number strength of the echo; 1 when left out
---@field specular_limit? number largest angle to the normal that echoes; the sonar's own when left out [rad]

---Adds a solid polygon, with holes if wanted.
---
---Fails on bad shape or number; name taken; ground needed by the start or a place.
---
---```lua
---meander.world.new {}:add_polygon { outer = {{2, 2}, {4, 2}, {3, 4}} }
---```
---@param options world.add_polygon.options its rim and more
---@return thing # the new thing
function world:add_polygon(options) end

---@class world.add_box.options
---@field center meander.point its centre [m]
---@field size meander.size extent along its own x and y [m]
---@field heading? number turn of its own x axis [rad]; 0 when left out
---@field name? string its name; "kind number" when left out
---@field echo? number strength of the echo; 1 when left out
---@field specular_limit? number largest angle to the normal that echoes; the sonar's own when left out [rad]

---Adds a solid rectangle.
---
---Fails on bad shape or number; name taken; ground needed by the start or a place.
---
---```lua
---meander.world.new {}:add_box { center = {3, 2}, size = {0.6, 0.4}, heading = deg(30) }
---```
---@param options world.add_box.options its centre, size and more
---@return thing # the new thing
function world:add_box(options) end

---@class world.add_disc.options
---@field center meander.point its centre [m]
---@field radius number its radius [m]
---@field name? string its name; "kind number" when left out
---@field echo? number strength of the echo; 1 when left out
---@field specular_limit? number largest angle to the normal that echoes; the sonar's own when left out [rad]

---Adds a solid disc: a pole, a pillar, a bin.
---
---Fails on bad shape or number; name taken; ground needed by the start or a place.
---
---```lua
---meander.world.new {}:add_disc { center = {3, 2}, radius = 0.2 }
---```
---@param options world.add_disc.options its centre, radius and more
---@return thing # the new thing
function world:add_disc(options) end

---@class world.add_door.options
---@field open? boolean an open door is not there; false when left out
---@field from? meander.point one end of a straight wall [m]
---@field to? meander.point its other end [m]
---@field points? meander.point[] corners of a wall [m]
---@field closed? boolean joins the last of the points to the first; false when left out
---@field outer? meander.point[] corners of a polygon [m]
---@field holes? meander.point[][] rims of its free areas [m]
---@field center? meander.point centre of a box or disc [m]
---@field size? meander.size extent of a box [m]
---@field heading? number turn of a box [rad]; 0 when left out
---@field radius? number radius of a disc [m]
---@field name? string its name; "kind number" when left out
---@field echo? number strength of the echo; 1 when left out
---@field specular_limit? number largest angle to the normal that echoes; the sonar's own when left out [rad]

---Adds an obstacle that opens and closes; its keys tell its shape.
---
---Fails on bad shape or number; name taken; ground needed by the start or a place.
---
---```lua
---meander.world.new {}:add_door { from = {3, 2}, to = {4, 2} }
---```
---@param options? world.add_door.options its shape and more
---@return thing # the new thing
function world:add_door(options) end

---@alias meander.motion_name 'waypoints'|'random_walk'

---@class world.add_mover.options
---@field center meander.point where it starts [m]
---@field radius number its radius [m]
---@field motion? meander.motion_name how it moves; 'waypoints' when left out
---@field waypoints? meander.point[] visited in a round [m]
---@field speed? number its speed [m/s]; 0.5 when left out
---@field yields? boolean stops for robots in its way; false: blind; true when left out
---@field name? string its name; "kind number" when left out

---Adds a disc that moves by itself once a simulation runs.
---
---Fails on bad shape or number; name taken; ground needed by the start or a place.
---
---```lua
---meander.world.new {}:add_mover { center = {3, 2}, radius = 0.3, waypoints = {{3, 5}} }
---```
---@param options world.add_mover.options where it starts and how it moves
---@return thing # the new thing
function world:add_mover(options) end

---@class world.add_light.options
---@field position meander.point where it is [m]
---@field strength? number how bright it is; 1 when left out
---@field name? string its name; "kind number" when left out

---Adds a light.
---
---Fails on bad number; name taken.
---
---```lua
---meander.world.new {}:add_light { position = {3, 2} }
---```
---@param options world.add_light.options its position and more
---@return thing # the new thing
function world:add_light(options) end

---@class world.add_place.options
---@field position meander.point where it is [m]
---@field heading? number wanted on arrival [rad]
---@field tolerance? number arrived when this near [m]; 0.25 when left out
---@field name? string its name; "kind number" when left out

---Names a place: subgoals are given as places.
---
---Fails on name taken; not on free ground.
---
---```lua
---meander.world.new {}:add_place { position = {3, 2}, name = 'hall' }
---```
---@param options world.add_place.options its position and more
---@return thing # the new thing
function world:add_place(options) end

---Removes things.
---
---Fails on no such thing.
---
---```lua
---w = meander.world.new {}
---w:remove(w:add_disc { center = {3, 2}, radius = 0.2 })
---```
---@param things thing|string|string|(thing|string|string)[] a thing, its name, a pattern such as 'crate*' (an exact name wins), or a list of these
function world:remove(things) end

---Gives a thing a new form; the keys are those of its kind.
---
---Fails on as for adding it.
---
---```lua
---w = meander.world.new {}
---t = w:add_disc { center = {3, 2}, radius = 0.2 }
---w:replace(t, { center = {3, 2}, size = {1, 1} })
---```
---@param thing thing|string the thing or its name
---@param options table the new form
function world:replace(thing, options) end

---Shifts things; movers take their waypoints along.
---
---Fails on no such thing; it may not stand there.
---
---```lua
---w = meander.world.new {}
---w:add_disc { center = {3, 2}, radius = 0.2, name = 'bin' }
---w:move('bin', {1, 0})
---```
---@param things thing|string|string|(thing|string|string)[] a thing, its name, a pattern such as 'crate*' (an exact name wins), or a list of these
---@param by meander.point how far [m]
function world:move(things, by) end

---Turns things counter-clockwise.
---
---Fails on no such thing; it may not stand there.
---
---```lua
---w = meander.world.new {}
---w:add_box { center = {3, 2}, size = {1, 2}, name = 'desk' }
---w:turn('desk', deg(30))
---```
---@param things thing|string|string|(thing|string|string)[] a thing, its name, a pattern such as 'crate*' (an exact name wins), or a list of these
---@param by number angle [rad]
---@param about? meander.point point; their middle when left out [m]
function world:turn(things, by, about) end

---Scales positions and sizes.
---
---Fails on no such thing; it may not stand there.
---
---```lua
---w = meander.world.new {}
---w:add_box { center = {3, 2}, size = {1, 2}, name = 'desk' }
---w:scale('desk', 0.5)
---```
---@param things thing|string|string|(thing|string|string)[] a thing, its name, a pattern such as 'crate*' (an exact name wins), or a list of these
---@param factor number above 0
---@param about? meander.point point; their middle when left out [m]
function world:scale(things, factor, about) end

---Moves points and centres to the nearest crossing of a grid.
---
---Fails on no such thing; a shape would become invalid.
---
---```lua
---w = meander.world.new {}
---w:add_disc { center = {3.1, 2}, radius = 0.2, name = 'bin' }
---w:snap('bin', 0.5)
---```
---@param things thing|string|string|(thing|string|string)[] a thing, its name, a pattern such as 'crate*' (an exact name wins), or a list of these
---@param step number distance of the grid lines [m]
function world:snap(things, step) end

---Gives a thing another name.
---
---Fails on no such thing; name taken.
---
---```lua
---w = meander.world.new {}
---w:rename(w:add_light { position = {1, 1} }, 'lamp')
---```
---@param thing thing|string the thing or its name
---@param name string the new name
function world:rename(thing, name) end

---Opens a door.
---
---Fails on no such thing; no door.
---
---```lua
---w = meander.world.new {}
---w:open(w:add_door { from = {3, 2}, to = {4, 2} })
---```
---@param door thing|string the door or its name
function world:open(door) end

---Closes a door.
---
---Fails on no such thing; no door; something stands there.
---
---```lua
---w = meander.world.new {}
---w:close(w:add_door { from = {3, 2}, to = {4, 2} })
---```
---@param door thing|string the door or its name
function world:close(door) end

---Takes back edits; a transaction is one step.
---
---Fails on a negative number of steps.
---
---```lua
---w = meander.world.new {}
---w:add_light { position = {1, 1} }
---print(w:undo())
---```
---@param steps? integer how many; 1 when left out
---@return integer # how many there were
function world:undo(steps) end

---Does again what undo took back.
---
---Fails on a negative number of steps.
---
---```lua
---w = meander.world.new {}
---w:add_light { position = {1, 1} }
---w:undo()
---print(w:redo())
---```
---@param steps? integer how many; 1 when left out
---@return integer # how many there were
function world:redo(steps) end

---All or nothing: when the function fails, everything it did to the world is taken back and the error goes on. One undo step.
---
---Fails on those of the function.
---
---```lua
---w = meander.world.new {}
---w:transaction(function() w:add_light { position = {1, 1} } end)
---```
---@param body function function that edits the world
function world:transaction(body) end

---Worlds: what stands where.
meander.world = {}

---@class meander.world.new.options
---@field title? string its name
---@field note? string what the world shows, and its source
---@field bounds? meander.box lower left and upper right corner; {{0, 0}, {10, 10}} when left out [m]
---@field start? meander.pose|false where robots start; false: nowhere [m, rad]

---Makes an empty world.
---
---Fails on bounds that are empty or not finite; a start outside.
---
---```lua
---w = meander.world.new { title = 'yard', bounds = {{0, 0}, {12, 9}} }
---```
---@param options? meander.world.new.options title, bounds and start
---@return world # the world
function meander.world.new(options) end

---Reads a world file.
---
---Fails on no such file; what is wrong in it, with line and key.
---
---```lua
---w = meander.world.open 'worlds/office.toml'
---```
---@param path string a .toml file
---@return world # the world
function meander.world.open(path) end

---Reads a world from the text of a world file.
---
---Fails on what is wrong in it, with line and key.
---
---```lua
---w = meander.world.from_toml(meander.world.new {}:to_toml())
---```
---@param text string TOML text
---@return world # the world
function meander.world.from_toml(text) end

---@alias meander.unknown_name 'auto'|'free'|'occupied'

---@alias meander.convention_name 'nav2'|'ros1'

---@class meander.world.import.options
---@field resolution? number size of a pixel or cell (pictures, MovingAI maps) [m/pixel]; 0.05 when left out
---@field threshold? number grey from which on a pixel is light (pictures); 0: chosen by Otsu's method; 0 when left out
---@field negate? boolean walls are light on dark (pictures); false when left out
---@field unknown? meander.unknown_name what unknown cells are (ROS maps): solid and a warning where doubtful, free, or solid; 'auto' when left out
---@field convention? meander.convention_name whose comparisons count at the thresholds (ROS maps); 'nav2' when left out
---@field index? integer which of the worlds (BARN tables); 0 when left out
---@field epsilon? number how far a straight outline may leave the edges of cells (maps and pictures) [cells]; 0.49 when left out
---@field min_area? number smaller solid patches are dropped as specks (maps and pictures) [m^2]; 0 when left out

---Reads other people's maps by suffix: world files, ROS maps (.yaml), pictures of floor plans (.png, .pgm, .jpg), BARN tables (.csv), MovingAI maps and ARIA line maps (.map).
---
---Fails on no such file; unknown suffix; what is wrong in it.
---
---```lua
---w, report = meander.world.import('worlds/office.toml')
---```
---@param path string a .toml, .yaml, .yml, .png, .pgm, .jpg, .jpeg, .bmp, .tif, .tiff, .csv or .map file
---@param options? meander.world.import.options how to read it
---@return world # the world, and a list of lines that say what was done
---@return string[]
function meander.world.import(path, options) end

---@class world.export_ros.options
---@field resolution? number side of a cell [m]; 0.05 when left out

---Writes a ROS map: a .yaml file and a .pgm picture beside it.
---
---Fails on the files cannot be written.
---
---```lua
---meander.world.new {}:export_ros(os.tmpname() .. '.yaml', { resolution = 0.1 })
---```
---@param path string the .yaml file
---@param options? world.export_ros.options size of the cells
function world:export_ros(path, options) end

---Changes title, note, bounds or start; what is not given stays.
---
---Fails on something would be outside or in the way.
---
---```lua
---w = meander.world.new {}
---w:set { title = 'yard', start = {1, 1, 0} }
---```
---@param options? meander.world.new.options what to change
function world:set(options) end

---@alias meander.kind_name 'clutter'

---@class meander.world.generate.options
---@field kind? meander.kind_name what kind of world; 'clutter' when left out
---@field seed? integer the same seed, the same world; 1 when left out
---@field density? number share of the ground that objects cover; 0.1 when left out
---@field route? number from start to goal leads a way that stays so far from everything [m]; 0.4667 when left out
---@field disc_radius_min? number least radius of a disc [m]; 0.12 when left out
---@field disc_radius_max? number largest radius of a disc [m]; 0.35 when left out
---@field box_side_min? number least side of a box [m]; 0.25 when left out
---@field box_side_max? number largest side of a box [m]; 0.9 when left out
---@field boxes? number share of boxes among the objects; 0.5 when left out
---@field width? number of the room, along x [m]; 10 when left out
---@field height? number of the room, along y [m]; 10 when left out
---@field draws? integer tries to find such a world before giving up; 400 when left out

---Makes a world from a seed: clutter, boxes and discs strewn over a room.
---
---Fails on a number out of range.
---
---```lua
---w = meander.world.generate { kind = 'clutter', seed = 3, density = 0.08 }
---```
---@param options? meander.world.generate.options what kind, the seed, how dense, how wide a route
---@return world|nil # the world; or nil and why when there is none
---@return string|nil
function meander.world.generate(options) end

---A native copy of a list, with min, max, mean and slices.
---
---```lua
---print(meander.numbers({3, 1, 2}):mean())
---```
---@param list number[] numbers
---@return numbers # the copy
function meander.numbers(list) end

---A copy as a plain list.
---
---```lua
---print(#meander.numbers({3, 1, 2}):totable())
---```
---@return number[] # list of numbers
function numbers:totable() end

---A view of a part.
---
---```lua
---print(meander.numbers({3, 1, 2}):slice(1, 4))
---```
---@param first integer index, 1 first, negative from the end
---@param last? integer index; the last when left out
---@param step? integer every so many; 1 when left out
---@return numbers # the part
function numbers:slice(first, last, step) end

---A list of what a function makes of each number.
---
---Fails on those of the function.
---
---```lua
---meander.numbers({3, 1, 2}):map(math.floor)
---```
---@param function_ fun(number: any, index: any): ...any function(number, index) that returns a value
---@return any[] # list of what it returned
function numbers:map(function_) end

---The smallest number and where it is.
---
---```lua
---print(meander.numbers({3, 1, 2}):min())
---```
---@return number|nil # number and index, nil when there are none
---@return integer|nil
function numbers:min() end

---The largest number and where it is.
---
---```lua
---print(meander.numbers({3, 1, 2}):max())
---```
---@return number|nil # number and index, nil when there are none
---@return integer|nil
function numbers:max() end

---The sum.
---
---```lua
---print(meander.numbers({3, 1, 2}):sum())
---```
---@return number # number
function numbers:sum() end

---The mean.
---
---```lua
---print(meander.numbers({3, 1, 2}):mean())
---```
---@return number|nil # number, nil when there are none
function numbers:mean() end

---A native copy of a list of rows (32-bit numbers).
---
---Fails on rows of different length.
---
---```lua
---print(meander.matrix { {1, 2}, {3, 4} }[2][1])
---```
---@param rows number[][] lists of equal length
---@return matrix # the copy
function meander.matrix(rows) end

---A view of a column.
---
---Fails on no such column.
---
---```lua
---print(meander.matrix({ {1, 2}, {3, 4} }):column(2))
---```
---@param index integer 1 first
---@return numbers # the column
function matrix:column(index) end

---A view of everything, row after row.
---
---```lua
---print(meander.matrix({ {1, 2}, {3, 4} }):all():max())
---```
---@return numbers # the numbers
function matrix:all() end

---A copy as plain lists.
---
---```lua
---print(#meander.matrix({ {1, 2}, {3, 4} }):totable())
---```
---@return number[][] # list of rows
function matrix:totable() end

---Local navigation by sonar readings and odometry alone.
meander.polar = {}

---@alias meander.robot_name 'nomad200'|'scout'|'alice'

---@alias meander.drive_name 'unicycle'|'omnidirectional'

---@class meander.polar.potential_field.options.robot.body
---@field radius? number radius of the round body [m]; 0.2667 when left out
---@field v_max? number largest forward speed [m/s]; 0.6096 when left out
---@field v_min? number least speed; 0: no reversing [m/s]; 0 when left out
---@field w_max? number largest turning rate [rad/s]; 0.785398 when left out
---@field a_v? number largest acceleration and braking [m/s^2]; 0.762 when left out
---@field a_w? number largest turning acceleration [rad/s^2]; 1.0472 when left out
---@field drive? meander.drive_name unicycle: forward and turning; omnidirectional: in any direction; 'unicycle' when left out

---@class meander.polar.potential_field.options.robot.sonar
---@field count? integer number of transducers; 16 when left out
---@field radius? number radius of the circle that the transducers sit on [m]; 0.23 when left out
---@field first? number bearing of the first transducer [rad]; 0 when left out

---@class meander.polar.potential_field.options.robot.bumper
---@field count? integer number of transducers; 20 when left out
---@field radius? number radius of the circle that the transducers sit on [m]; 0.2667 when left out
---@field first? number bearing of the first transducer [rad]; 0 when left out

---@class meander.polar.potential_field.options.robot.whisker
---@field count? integer number of transducers; 0 when left out
---@field radius? number radius of the circle that the transducers sit on [m]; 0.15 when left out
---@field first? number bearing of the first transducer [rad]; 0 when left out

---@class meander.polar.potential_field.options.robot
---@field preset? meander.robot_name the named set that the other keys change
---@field name? string name of the platform
---@field body? meander.polar.potential_field.options.robot.body size and limits of the body
---@field sonar? meander.polar.potential_field.options.robot.sonar places of the sonars
---@field bumper? meander.polar.potential_field.options.robot.bumper places of the bumpers
---@field whisker? meander.polar.potential_field.options.robot.whisker places of the whiskers' roots
---@field light? meander.polar.potential_field.options.robot.whisker places of the light sensors
---@field period? number control cycle [s]; 0.33 when left out

---@class meander.polar.potential_field.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field influence? number surfaces nearer to the hull than this push [m]; 0.43 when left out
---@field attraction? number strength of the pull; 1 when left out
---@field repulsion? number strength of the push; 0.0025 when left out
---@field attraction_reach? number the pull is constant farther away, falls linearly nearer [m]; 0.4 when left out
---@field turn_gain? number turning rate per radian of heading error [1/s]; 0.63 when left out
---@field margin? number hull distance that braking keeps free [m]; 0.02 when left out
---@field headway? number and more the faster the robot is: so many seconds of its way [s]; 0.1 when left out
---@field caution? number hull distance below which the speed falls [m]; 0.15 when left out
---@field half_cone? number half angle within which an echo may have come from [rad]; 0.218166 when left out
---@field range_min? number least range of the sonars: what reads so near may touch the hull [m]; 0.152 when left out
---@field patience? number trapped after so long without progress [s]; 15 when left out
---@field progress? number what counts as progress towards the subgoal [m]; 0.1 when left out

---Artificial potential field on the readings of the present cycle: no memory, no map.
---
---Fails on a number out of range.
---
---```lua
---print(meander.polar.potential_field { influence = 0.8 })
---```
---@param options? meander.polar.potential_field.options the robot it drives, and the field
---@return navigator # the navigator
function meander.polar.potential_field(options) end

---Navigators and guides by name.
meander.autonomy = {}

---The names that sim:drive takes as navigator.
---
---```lua
---print(meander.autonomy.navigators()[1])
---```
---@return string[] # list of names
function meander.autonomy.navigators() end

---A navigator by name, with its usual options.
---
---Fails on unknown name.
---
---```lua
---print(meander.autonomy.navigator 'potential_field')
---```
---@param name string which
---@param robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot; nomad200 when left out
---@return navigator # the navigator
function meander.autonomy.navigator(name, robot) end

---@alias meander.when_trapped_name 'stop'|'skip'|'insist'

---@class meander.autonomy.subgoal_list.options
---@field subgoals (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to: points, one after the other [m]
---@field hand_over? number go on to the next subgoal when this near, so that the robot need not slow down; 0: the subgoal's tolerance [m]; 0 when left out
---@field when_trapped? meander.when_trapped_name stop, skip to the next subgoal, or insist on this one; 'stop' when left out

---A guide: one subgoal after the other.
---
---Fails on no subgoal; names of places, because a guide knows no world.
---
---```lua
---print(meander.autonomy.subgoal_list { subgoals = { {4, 2}, {6, 2} } })
---```
---@param options meander.autonomy.subgoal_list.options the subgoals, and when the next one's turn is
---@return guide # the guide
function meander.autonomy.subgoal_list(options) end

---What to do now.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---print(meander.polar.potential_field({}):step(s.observation, {4, 2}))
---```
---@param observation observation what the robot sees
---@param subgoal string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any } where to, in the odometry frame [m]
---@return number # v [m/s], w [rad/s], status ('driving', 'arrived', 'trapped') and the reason when trapped
---@return number
---@return 'driving'|'arrived'|'trapped'
---@return string
function navigator:step(observation, subgoal) end

---Forgets everything: a new run begins.
---
---```lua
---meander.polar.potential_field({}):reset()
---```
function navigator:reset() end

---Begins again.
---
---```lua
---meander.autonomy.subgoal_list({ subgoals = { {4, 2} } }):reset()
---```
function guide:reset() end

---@class meander.polar.vfh_plus.options.steering
---@field turn_gain? number turning rate per radian of heading error [1/s]; 2.3 when left out
---@field margin? number hull distance that braking keeps free [m]; 0.1 when left out
---@field headway? number way that braking leaves besides: so many seconds at the present speed [s]; 0.15 when left out
---@field caution? number hull distance below which the speed falls [m]; 0.33 when left out

---@class meander.polar.vfh_plus.options.memory
---@field scans? integer how many scans are remembered; 6 when left out
---@field range_min? number least range of the sonars: what reads so near may touch the hull [m]; 0.152 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field saturated_gap? number a reading at the least range counts as a point this far from the hull [m]; 0.04 when left out
---@field contradictions? integer newer beams through a point that make it forgotten; 0: never; 4 when left out
---@field contradiction_angle? number how far off a beam's axis its range still tells that a place is free [rad]; 0.1 when left out

---@class meander.polar.vfh_plus.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field sectors? integer of the histogram; 72 when left out
---@field window? number what is farther does not count [m]; 1 when left out
---@field enlarge? number by how much more than the robot's radius obstacles are enlarged [m]; 0.02 when left out
---@field low? number a sector is free when its density is below this; 0.45 when left out
---@field high? number and blocked above this; between them it stays what it was; 1 when left out
---@field wide_valley? integer openings of more sectors than this have two edges to drive along [sectors]; 11 when left out
---@field goal_weight? number cost of turning away from the subgoal; 5 when left out
---@field heading_weight? number cost of turning; 2.3 when left out
---@field previous_weight? number cost of another direction than the last; 2.6 when left out
---@field half_cone? number half angle within which an echo may have come from [rad]; 0.1 when left out
---@field patience? number trapped after so long without progress [s]; 15 when left out
---@field progress? number what counts as progress towards the subgoal [m]; 0.1 when left out
---@field steering? meander.polar.vfh_plus.options.steering how the direction is driven
---@field memory? meander.polar.vfh_plus.options.memory what is remembered of the sonar

---VFH+: a polar histogram of what was seen lately, from which free directions are picked by cost.
---
---Fails on a number out of range.
---
---```lua
---print(meander.polar.vfh_plus { window = 1.5 })
---```
---@param options? meander.polar.vfh_plus.options the robot it drives, and the method
---@return navigator # the navigator
function meander.polar.vfh_plus(options) end

---@class meander.polar.dynamic_window.options.memory
---@field scans? integer how many scans are remembered; 12 when left out
---@field range_min? number least range of the sonars: what reads so near may touch the hull [m]; 0.152 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field saturated_gap? number a reading at the least range counts as a point this far from the hull [m]; 0.04 when left out
---@field contradictions? integer newer beams through a point that make it forgotten; 0: never; 2 when left out
---@field contradiction_angle? number how far off a beam's axis its range still tells that a place is free [rad]; 0.1 when left out

---@class meander.polar.dynamic_window.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field speeds? integer forward speeds tried in the window; 11 when left out
---@field turns? integer turning rates tried in the window; 21 when left out
---@field heading_weight? number of facing the subgoal in the end; 3 when left out
---@field distance_weight? number of the free way along the arc; 0.2 when left out
---@field speed_weight? number of going fast; 0.32 when left out
---@field margin? number hull distance that counts as contact [m]; 0.07 when left out
---@field reach? number a longer free way is not worth more [m]; 3.4 when left out
---@field half_cone? number half angle within which an echo may have come from [rad]; 0.218 when left out
---@field patience? number trapped after so long without progress [s]; 15 when left out
---@field progress? number what counts as progress towards the subgoal [m]; 0.1 when left out
---@field memory? meander.polar.dynamic_window.options.memory what is remembered of the sonar

---The dynamic window approach: of the velocities in reach, the best sum of heading, free way, speed.
---
---Fails on a number out of range.
---
---```lua
---print(meander.polar.dynamic_window { heading_weight = 1 })
---```
---@param options? meander.polar.dynamic_window.options the robot it drives, and the method
---@return navigator # the navigator
function meander.polar.dynamic_window(options) end

---@class meander.polar.tangent_bug.options.steering
---@field turn_gain? number turning rate per radian of heading error [1/s]; 1.1 when left out
---@field margin? number hull distance that braking keeps free [m]; 0.09 when left out
---@field headway? number way that braking leaves besides: so many seconds at the present speed [s]; 0.42 when left out
---@field caution? number hull distance below which the speed falls [m]; 0.08 when left out

---@class meander.polar.tangent_bug.options.memory
---@field scans? integer how many scans are remembered; 17 when left out
---@field range_min? number least range of the sonars: what reads so near may touch the hull [m]; 0.152 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field saturated_gap? number a reading at the least range counts as a point this far from the hull [m]; 0.04 when left out
---@field contradictions? integer newer beams through a point that make it forgotten; 0: never; 1 when left out
---@field contradiction_angle? number how far off a beam's axis its range still tells that a place is free [rad]; 0.1 when left out

---@class meander.polar.tangent_bug.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field directions? integer in which the free way is looked at; 72 when left out
---@field reach? number how far the readings are trusted [m]; 1.9 when left out
---@field clearance? number hull distance at which walls are passed [m]; 0.06 when left out
---@field jump? number neighbours whose free ways differ by more are the end of an obstacle [m]; 0.17 when left out
---@field constancy? number another end is taken only when its way is shorter by this [m]; 0.53 when left out
---@field follow_look? number free way that makes a direction good enough along a wall [m]; 0.87 when left out
---@field leave? number a wall is left when a place so much nearer to the subgoal than any of it is in reach [m]; 0.16 when left out
---@field loop? number coming so near to where following began means that there is no way [m]; 0.5 when left out
---@field half_cone? number half angle within which an echo may have come from [rad]; 0 when left out
---@field patience? number trapped after so long at the same place [s]; 15 when left out
---@field progress? number what counts as another place [m]; 0.3 when left out
---@field steering? meander.polar.tangent_bug.options.steering how the direction is driven
---@field memory? meander.polar.tangent_bug.options.memory what is remembered of the sonar

---TangentBug: to the subgoal past the ends of what is in the way, else along walls.
---
---Fails on a number out of range.
---
---```lua
---print(meander.polar.tangent_bug { reach = 2 })
---```
---@param options? meander.polar.tangent_bug.options the robot it drives, and the method
---@return navigator # the navigator
function meander.polar.tangent_bug(options) end

---@alias meander.mode_name 'full'|'paper'

---@alias meander.radii_name 'uniform'|'log'

---@alias meander.layout_name 'fixed'|'self_organising'

---@alias meander.weights_name 'finite_volume'|'euclidean'|'lattice'

---@class meander.polar.navigator.options.map.organising
---@field share? number of the units that follow the readings; the others stay where a fixed layout has them; 0.5 when left out
---@field rate? number how fast older readings are forgotten [1/cycle]; 0.02 when left out
---@field step? number the layout moves when a ring or sector is off its place by so much of the distance to the next; 0.25 when left out

---@class meander.polar.navigator.options.map
---@field rings? integer rings of units, the centre included; 100 when left out
---@field sectors? integer units on each ring; 48 when left out
---@field scope? number radius of the outermost ring [m]; 2.54 when left out
---@field radii? meander.radii_name equally spaced, or growing by a constant factor; 'uniform' when left out
---@field innermost? number radius of ring 1 of logarithmic radii [m]; 0.05 when left out
---@field layout? meander.layout_name fixed, or rings and sectors move to where the readings are; 'fixed' when left out
---@field weights? meander.weights_name weights of the connections; 'finite_volume' when left out
---@field kappa? number how fast activation decays along a way, with finite volumes [1/m]; 30 when left out
---@field margin? number units nearer to a point than the robot's radius and this are obstructed [m]; 0.05 when left out
---@field narrow_margin? number the same, when no activation reaches the robot otherwise [m]; 0.02 when left out
---@field merge? number remembered points in the same square of this size count once; 0: all count [m]; 0.03 when left out
---@field organising? meander.polar.navigator.options.map.organising how a self-organising layout learns

---@class meander.polar.navigator.options.memory
---@field scans? integer how many scans are remembered; 10 when left out
---@field range_min? number least range of the sonars: what reads so near may touch the hull [m]; 0.152 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field saturated_gap? number a reading at the least range counts as a point this far from the hull [m]; 0.04 when left out
---@field contradictions? integer newer beams through a point that make it forgotten; 0: never; 2 when left out
---@field contradiction_angle? number how far off a beam's axis its range still tells that a place is free [rad]; 0.1 when left out

---@class meander.polar.navigator.options.prediction
---@field enabled? boolean plan for where the robot will be when the command takes effect; true when left out
---@field latency? integer cycles until a command takes effect; -1: found out by watching the odometry; -1 when left out
---@field periods? integer recent control periods in the running average; 8 when left out

---@class meander.polar.navigator.options.solver
---@field passes? integer sweeps from the target round the map and back; 2 when left out
---@field exact? boolean sweep until nothing changes any more; false when left out

---@class meander.polar.navigator.options.subgoal
---@field read_radius? number the direction is that of the most active unit this far from the centre [m]; 0.2 when left out
---@field hysteresis? number another direction wins only if its way is so much shorter; finite volumes only [m]; 0.5 when left out
---@field hysteresis_ratio? number the same for other weights: only if its activation is so many times higher; 20 when left out
---@field hysteresis_sectors? integer directions so few sectors apart are not another direction; 4 when left out

---@class meander.polar.navigator.options.control
---@field speeds? integer forward speeds tried in the dynamic window; 11 when left out
---@field turns? integer turning rates tried in the dynamic window; 21 when left out
---@field hard_margin? number the hull must not come nearer to a point than this [m]; 0.07 when left out
---@field soft_margin? number nearer than this the robot goes slowly [m]; 0.3 when left out
---@field heading_cost? number cost of not facing the subgoal in the end [m/rad]; 0.4 when left out
---@field heading_reach? number nearer to the subgoal than this the heading matters less [m]; 0.15 when left out
---@field hard_cost? number cost of coming too near [m]; 10 when left out
---@field hard_base? number share of that cost at standstill; the rest grows with the speed; 0.2 when left out
---@field hard_samples? number cost of each sample of the trajectory that is too near [m]; 0.2 when left out
---@field soft_samples? number cost of eight samples in the slow zone [m]; 0.1 when left out
---@field soft_speed_cost? number cost of driving at full speed above soft_speed in the slow zone [m]; 2 when left out
---@field soft_speed? number speed in the slow zone that costs nothing [m/s]; 0.3 when left out
---@field near_margin? number a robot that stands nearer to a point than this is in the slow zone wherever it goes [m]; 0.2 when left out
---@field sample_step? number distance between samples of a trajectory [m]; 0.05 when left out
---@field samples? integer samples of a trajectory at most; 12 when left out

---@class meander.polar.navigator.options.trap.escape
---@field directions? integer in which the free way is looked at; 72 when left out
---@field reach? number how far the memory is trusted [m]; 1.9 when left out
---@field clearance? number hull distance at which walls are passed [m]; 0.03 when left out
---@field look? number free way that makes a direction good enough along a wall [m]; 0.4 when left out
---@field leave? number over when a place so much nearer to the target than ever before is in reach [m]; 0.16 when left out
---@field loop? number coming so near to where it has been means that there is no way on this side [m]; 0.5 when left out

---@class meander.polar.navigator.options.trap
---@field watch? boolean notice being trapped; true when left out
---@field patience? number trapped after so long without progress [s]; 15 when left out
---@field progress? number what counts as progress towards the subgoal [m]; 0.1 when left out
---@field escapes? integer tries to get out along the wall, on one side and the other, before the guide is told; 4 when left out
---@field escape? meander.polar.navigator.options.trap.escape along the wall

---@class meander.polar.navigator.options.own
---@field weights? fun(ring: any): ...any function(ring): weights {inward =, outward =, lateral =, leak =, inward_diagonal =, outward_diagonal =} of a ring, which has ring, rings, sectors, radius, inner, outer, spacing
---@field objective? fun(candidate: any): ...any function(candidate): its cost; the least is taken; a candidate has v, w, x, y, heading, distance, heading_error, samples, hard, soft, near
---@field subgoal? fun(map: map): ...any function(map): ring and sector of the subgoal, or nil: no way; a map has rings, sectors, target, target_ring, previous, radii, bearings, activation

---@class meander.polar.navigator.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field mode? meander.mode_name with the remedies beyond the paper, or without them: then their options are refused; 'full' when left out
---@field map? meander.polar.navigator.options.map the polar map
---@field memory? meander.polar.navigator.options.memory the short-term memory
---@field prediction? meander.polar.navigator.options.prediction prediction of the configuration
---@field solver? meander.polar.navigator.options.solver how the equilibrium is found
---@field subgoal? meander.polar.navigator.options.subgoal how the subgoal is read off
---@field control? meander.polar.navigator.options.control motion control
---@field trap? meander.polar.navigator.options.trap trapped: when, and what then
---@field own? meander.polar.navigator.options.own parts of one's own, as functions

---The polar neural map navigator: sonar memory, prediction, polar map, motion control.
---
---Fails on a number out of range; own weights without a stable equilibrium.
---
---```lua
---print(meander.polar.navigator { map = { rings = 100, sectors = 32 } })
---```
---@param options? meander.polar.navigator.options the robot it drives, and its parts
---@return navigator # the navigator
function meander.polar.navigator(options) end

---What the last cycle of a polar navigator was like: map, activation, memory, choice.
---
---Fails on another kind of navigator; one that has not driven yet.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---n = meander.polar.navigator {}
---n:step(s.observation, {4, 2})
---print(n:inspect().subgoal.x)
---```
---@return table # table of what it had before it
function navigator:inspect() end

---Simulation: commands in, observations out.
meander.sim = {}

---@alias meander.sonar_name 'ideal'|'nomad'|'real'

---@alias meander.firing_name 'simultaneous'|'sequence'

---@class meander.sim.new.options.sonar
---@field preset? meander.sonar_name the named set that the other keys change
---@field half_cone? number half opening angle of the cone [rad]; 0.218166 when left out
---@field range_min? number least range; a transducer in contact reads this [m]; 0.152 when left out
---@field range_max? number range read when nothing echoes [m]; 6.477 when left out
---@field incidence? boolean walls echo only near the normal; true when left out
---@field incidence_limit? number largest angle to the normal that echoes [rad]; 0.523599 when left out
---@field incidence_jitter? number standard deviation of that limit per reading [rad]; 0 when left out
---@field jitter_hold? number readings for which one jitter value holds, on average; 10 when left out
---@field near_field? number nearer than this everything echoes; 0: off [m]; 0.3 when left out
---@field corner_range? number convex corners answer up to here; 0: off [m]; 1.75 when left out
---@field bounce? boolean beams without an echo travel on after one mirror reflection; false when left out
---@field noise? number standard deviation, constant part [m]; 0.01 when left out
---@field noise_proportional? number standard deviation, share of the range; 0.01 when left out
---@field dropout? number probability of reading the maximum; 0 when left out
---@field spurious? number probability of a short false echo; 0 when left out
---@field repeat? number probability of repeating the last reading exactly; 0 when left out
---@field firing? meander.firing_name all at once or one group after the other while the robot moves; 'sequence' when left out
---@field fired_together? integer transducers per group of the firing sequence; 1 when left out
---@field crosstalk? boolean transducers fired together hear each other; false when left out
---@field receive_lobe? number half angle in which a foreign echo is heard [rad]; 0.610865 when left out

---@alias meander.drift_name 'none'|'good'|'poor'|'alice'

---@class meander.sim.new.options.drift
---@field preset? meander.drift_name the named set that the other keys change
---@field distance_bias? number relative error of distances; 0 when left out
---@field turn_bias? number relative error of turns; 0 when left out
---@field veer? number false turn per metre [rad/m]; 0 when left out
---@field distance_noise? number random error of distances per root metre [m/m^0.5]; 0 when left out
---@field turn_noise? number random error of turns per root radian [rad/rad^0.5]; 0 when left out
---@field veer_noise? number random false turn per root metre [rad/m^0.5]; 0 when left out
---@field slip? number length of the error vector that every motion gets, as a share of the motion; 0 when left out
---@field slip_spread? number how far that share varies, evenly; 0 when left out
---@field slip_length? number way over which the error vector keeps its direction [m]; 1 when left out

---@class meander.sim.new.options.whisker
---@field reach? number length of a whisker [m]; 0.15 when left out
---@field false_alarm? number chance that a free whisker tells a contact; 0.01 when left out
---@field miss? number chance that a bent whisker tells none; 0.02 when left out

---@class meander.sim.new.options.light
---@field lobe? number standard deviation of the lobe [rad]; 0.436332 when left out
---@field contrast? number how strongly the logarithm compresses the brightness; 100 when left out
---@field noise? number standard deviation of the gain, as a share of the reading; 0.03 when left out

---@class meander.sim.new.options.robots
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot, by name or in detail
---@field sonar? meander.sonar_name|meander.sim.new.options.sonar model of the sonars, by name or in detail
---@field drift? meander.drift_name|meander.sim.new.options.drift errors of the odometry, by name or in detail; none when left out
---@field whisker? meander.sim.new.options.whisker model of the whiskers, for platforms that have some
---@field light? meander.sim.new.options.light model of the light sensors, for platforms that have some
---@field start? meander.pose|string|thing where it starts; the world's start when left out [m, rad]

---@class meander.sim.new.options
---@field world world where it happens; edits take effect at the next step
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot, by name or in detail
---@field sonar? meander.sonar_name|meander.sim.new.options.sonar model of the sonars, by name or in detail
---@field drift? meander.drift_name|meander.sim.new.options.drift errors of the odometry, by name or in detail; none when left out
---@field whisker? meander.sim.new.options.whisker model of the whiskers, for platforms that have some
---@field light? meander.sim.new.options.light model of the light sensors, for platforms that have some
---@field start? meander.pose|string|thing where it starts; the world's start when left out [m, rad]
---@field robots? meander.sim.new.options.robots[] several robots instead of one, each with a table of its own
---@field seed? integer seed of all random streams; 1 when left out
---@field period? number control cycle; 0: the platform's own [s]; 0 when left out
---@field period_jitter? number standard deviation of the control cycle, as a share of it; 0 when left out
---@field command_delay? integer cycles until a command takes effect; 0 when left out

---Places robots in a world and starts the clock.
---
---Fails on no start; a start that is not free; a number out of range.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/office.toml', robot = 'nomad200', sonar = 'nomad', seed = 7 }
---```
---@param options meander.sim.new.options the world, the robot and the seed
---@return sim # the simulation
function meander.sim.new(options) end

---One control cycle.
---
---Fails on not one command per robot.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---print(s:step(0.3, 0).pose, s:step { v = 0.3, w = 0.1 }.time)
---```
---@param command number|{ v?: any, w?: any }|({ v?: any, w?: any })[] forward speed, {v =, w =}, or a list of these for several robots [m/s]
---@param w? number turning rate, when the first argument is a speed [rad/s]
---@return observation # what the first robot sees then
function sim:step(command, w) end

---Back to the start, in the world as it is now.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---s:step(0.3, 0)
---s:reset()
---```
---@param seed? integer another seed; the same one, and so the same run, when left out
function sim:reset(seed) end

---An independent copy in this moment, with its own copy of the world.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---print(s:fork():hash() == s:hash())
---```
---@return sim # the copy
function sim:fork() end

---Hash of everything that decides how it goes on.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---print(s:hash())
---```
---@return string # 16 hexadecimal digits
function sim:hash() end

---Writes a picture of this moment (.svg, .png).
---
---Fails on unknown suffix; the file cannot be written.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---s:save(os.tmpname() .. '.svg')
---```
---@param path string the suffix says what is written
function sim:save(path) end

---@alias meander.navigator_name 'polar'|'potential_field'|'vfh_plus'|'dynamic_window'|'tangent_bug'

---@class sim.drive.options.pilots
---@field navigator? meander.navigator_name|navigator|fun(observation: observation, subgoal: any): ...any|table<string, function> who drives
---@field subgoals? (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to: places or points, one after the other [m]
---@field guide? guide|fun(observation: observation, status: any): ...any|table<string, function> who says where to, instead of a list of subgoals
---@field hand_over? number go on to the next subgoal when this near, so that the robot need not slow down; 0: the subgoal's tolerance [m]; 0 when left out
---@field when_trapped? meander.when_trapped_name stop, skip to the next subgoal, or insist on this one; 'stop' when left out

---@class sim.drive.options
---@field navigator? meander.navigator_name|navigator|fun(observation: observation, subgoal: any): ...any|table<string, function> who drives
---@field subgoals? (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to: places or points, one after the other [m]
---@field guide? guide|fun(observation: observation, status: any): ...any|table<string, function> who says where to, instead of a list of subgoals
---@field hand_over? number go on to the next subgoal when this near, so that the robot need not slow down; 0: the subgoal's tolerance [m]; 0 when left out
---@field when_trapped? meander.when_trapped_name stop, skip to the next subgoal, or insist on this one; 'stop' when left out
---@field pilots? sim.drive.options.pilots[] for several robots: one table each with navigator and subgoals or guide
---@field on_step? fun(sim: sim): ...any function(sim) called after every cycle; it may edit the world; false ends the drive
---@field time_limit? number simulated time after which the drive ends [s]; 600 when left out
---@field stop_on_contact? boolean end at the first contact; false when left out
---@field record_every? integer keep every n-th cycle; 0: none; 1 when left out

---Closes the loop: guide, navigator, step, until the guide has finished, the time is up or on_step says so. What an interrupt or an error cuts short is kept: see last_run.
---
---Fails on unknown navigator or place; errors of the functions given.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } }
---print(run)
---```
---@param options? sim.drive.options who drives, and where to
---@return run|run[] # the run, or a list of runs where pilots were given
function sim:drive(options) end

---The run of its last drive, also of one that was interrupted or ended in an error.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } }
---print(s:last_run() == run)
---```
---@return run|run[] # the run as drive returns it, up to where it came; nil before the first drive and during one
function sim:last_run() end

---@class watch.options
---@field navigator? meander.navigator_name|navigator|fun(observation: observation, subgoal: any): ...any|table<string, function> who drives
---@field subgoals? (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to: places or points, one after the other [m]
---@field guide? guide|fun(observation: observation, status: any): ...any|table<string, function> who says where to, instead of a list of subgoals
---@field hand_over? number go on to the next subgoal when this near, so that the robot need not slow down; 0: the subgoal's tolerance [m]; 0 when left out
---@field when_trapped? meander.when_trapped_name stop, skip to the next subgoal, or insist on this one; 'stop' when left out
---@field pilots? sim.drive.options.pilots[] for several robots: one table each with navigator and subgoals or guide
---@field on_step? fun(sim: sim): ...any function(sim) called after every cycle; it may edit the world; false ends the drive
---@field time_limit? number simulated time after which the drive ends [s]; 600 when left out
---@field stop_on_contact? boolean end at the first contact; false when left out
---@field record_every? integer keep every n-th cycle; 0: none; 1 when left out
---@field speed? number simulated seconds per second, 1 when left out; 0 or math.huge: as fast as it goes
---@field rate? number pictures per second, at most [1/s]; 20 when left out

---Drives a sim as sim:drive does, or runs a run again, and shows it in the terminal meanwhile. Ctrl-C ends it; sim:last_run() is the run so far.
---
---Fails on those of sim:drive; a run without recorded steps.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---watch(s, { navigator = 'potential_field', subgoals = { {4, 2} } })
---```
---@param object any a sim or a run
---@param options? watch.options for a sim: who drives, and where to; for both: how fast it is shown
---@return run|run[] # the run, as sim:drive returns it
function watch(object, options) end

---Pictures: files, texts, plots, moving ones.
meander.render = {}

---@alias meander.hide_name 'ground'|'grid'|'cell'|'bar'|'sweep'|'cone'|'place'|'light'|'open_door'|'wall'|'door'|'mover'|'path'|'curve'|'echo'|'start'|'goal'|'contact'|'label'|'robot'

---@class meander.render.save.options
---@field width? integer width of the picture [px]; 1200 when left out
---@field height? integer largest height of the picture; 0: as the view needs [px]; 0 when left out
---@field hide? ('ground'|'grid'|'cell'|'bar'|'sweep'|'cone'|'place'|'light'|'open_door'|'wall'|'door'|'mover'|'path'|'curve'|'echo'|'start'|'goal'|'contact'|'label'|'robot')[] layers to leave out

---Writes a picture of anything that show() draws.
---
---Fails on something that has no picture; another suffix; the file cannot be written.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---meander.render.save(s, os.tmpname() .. '.png', { width = 400, hide = { 'cone', 'label' } })
---```
---@param object any what to draw
---@param path string a .svg or .png file
---@param options? meander.render.save.options size of a .png, layers
function meander.render.save(object, path, options) end

---@alias meander.render.text.options.mode 'ascii'|'color256'|'truecolor'

---@class meander.render.text.options
---@field columns? integer largest number of characters in a line; 80 when left out
---@field rows? integer largest number of lines; 24 when left out
---@field mode? meander.render.text.options.mode which characters and colours; 'ascii' when left out
---@field hide? ('ground'|'grid'|'cell'|'bar'|'sweep'|'cone'|'place'|'light'|'open_door'|'wall'|'door'|'mover'|'path'|'curve'|'echo'|'start'|'goal'|'contact'|'label'|'robot')[] layers to leave out

---The picture as lines of text, for logs and tests.
---
---Fails on something that has no picture.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---print(meander.render.text(s, { columns = 40, rows = 12 }))
---```
---@param object any what to draw
---@param options? meander.render.text.options size, kind of characters, layers
---@return string # the lines, each with its line feed
function meander.render.text(object, options) end

---@class meander.render.animate.options
---@field rate? number pictures per second, at most [1/s]; 20 when left out

---Shows what a function returns, again and again, until it returns nil or false; the last picture stays. Without a terminal only that is shown.
---
---Fails on something that has no picture; errors of the function.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---meander.render.animate(function(i) s:step(0.3, 0.2) return i <= 10 and s end)
---```
---@param frame fun(number: any): ...any function(number) that returns something to see
---@param options? meander.render.animate.options how fast
function meander.render.animate(frame, options) end

---@class meander.render.curve.words
---@field title? string stands above the picture
---@field x? string what the x axis shows, with its unit
---@field y? string what the y axis shows, with its unit

---A picture of numbers over their index; show(numbers) is the same without words.
---
---Fails on no finite number.
---
---```lua
---show(meander.render.curve({3, 1, 2}, { y = 'error [m]' }))
---```
---@param values number[]|numbers a list or view of numbers; gaps where they are not finite
---@param words? meander.render.curve.words what stands beside it
---@return picture # the picture, for show and save
function meander.render.curve(values, words) end

---@class meander.render.histogram.options
---@field bins? integer number of intervals; 0: by the count of the values; 0 when left out
---@field title? string stands above the picture
---@field x? string what the x axis shows, with its unit
---@field y? string what the y axis shows, with its unit

---A picture of how often numbers fall into equal intervals.
---
---Fails on no finite number.
---
---```lua
---show(meander.render.histogram({1, 2, 2, 3}, { bins = 3 }))
---```
---@param values number[]|numbers a list or view of numbers
---@param options? meander.render.histogram.options intervals and words
---@return picture # the picture, for show and save
function meander.render.histogram(values, options) end

---A picture of a matrix, first row on top; dark is much.
---
---Fails on no finite number.
---
---```lua
---show(meander.render.heat_map { {1, 2}, {3, 4} })
---```
---@param matrix matrix|number[][] the numbers, or a list of rows of them
---@param words? meander.render.curve.words what stands beside it
---@return picture # the picture, for show and save
function meander.render.heat_map(matrix, words) end

---@alias run.trace.name 'time'|'x'|'y'|'heading'|'odometry_x'|'odometry_y'|'odometry_heading'|'command_v'|'command_w'|'v'|'w'|'clearance'

---A figure over all recorded cycles.
---
---Fails on unknown name.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } }
---print(run:trace('clearance'):min())
---```
---@param name run.trace.name which
---@return numbers # the numbers
function run:trace(name) end

---The sonar readings of all recorded cycles.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } }
---print(run:sonar()[1]:min())
---```
---@return matrix # matrix, one row per cycle [m]
function run:sonar() end

---Its figures as one line of JSON.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } }
---print(run:to_json())
---```
---@return string # JSON text
function run:to_json() end

---Writes a picture (.svg, .png), a table (.csv) or the record (.jsonl).
---
---Fails on unknown suffix; the file cannot be written.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } }
---run:save(os.tmpname() .. '.csv')
---```
---@param path string the suffix says what is written
function run:save(path) end

---Kinds of robots.
meander.robot = {}

---The names that sim.new takes as robot.
---
---```lua
---print(table.concat(meander.robot.platforms(), ' '))
---```
---@return string[] # list of names
function meander.robot.platforms() end

---A kind of robot in detail: body, sensor places, control period.
---
---Fails on unknown name; a number out of range.
---
---```lua
---print(meander.robot.platform('nomad200').body.radius)
---```
---@param robot meander.robot_name|meander.polar.potential_field.options.robot its name, or a table that changes one
---@return table # table of options, as sim.new takes it
function meander.robot.platform(robot) end

---Where the echoes would be if they came from the axes of the sonars.
---
---```lua
---r = meander.sensor.scan { world = meander.world.new { start = {2, 2, 0} } }
---print(#r:points())
---```
---@return meander.point[] # list of points [m], without sonars that heard nothing
function reading:points() end

---Writes a picture (.svg, .png).
---
---Fails on unknown suffix; the file cannot be written.
---
---```lua
---r = meander.sensor.scan { world = meander.world.new { start = {2, 2, 0} } }
---r:save(os.tmpname() .. '.svg')
---```
---@param path string the suffix says what is written
function reading:save(path) end

---Sensors: from the truth to readings.
meander.sensor = {}

---@class meander.sensor.scan.options
---@field world world what stands around
---@field pose? meander.pose|string|thing where the robot stands; the world's start when left out [m, rad]
---@field sonar? meander.sonar_name|meander.sim.new.options.sonar model of the sonars, by name or in detail
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot: where its sonars sit
---@field seed? integer seed of the noise; 1 when left out

---One scan of the sonars, standing still.
---
---Fails on no pose; a number out of range.
---
---```lua
---show(meander.sensor.scan { world = meander.world.open 'worlds/office.toml', sonar = 'ideal' })
---```
---@param options meander.sensor.scan.options the world, the pose and the sonar model
---@return reading # the reading
function meander.sensor.scan(options) end

---@class meander.sensor.ray.options
---@field world world what stands around
---@field from meander.point where the ray begins [m]
---@field heading? number where it points [rad]; 0 when left out
---@field range? number how far it reaches [m]; 1000 when left out

---The first wall or solid on a straight ray.
---
---Fails on a number out of range.
---
---```lua
---print(meander.sensor.ray { world = meander.world.open 'worlds/office.toml', from = {1, 1}, heading = deg(90) })
---```
---@param options meander.sensor.ray.options the world and the ray
---@return number|nil # range [m], the thing hit and the point hit [m]; nil when there is nothing
---@return thing|nil
---@return meander.point|nil
function meander.sensor.ray(options) end

---The names that sim.new and scan take as sonar.
---
---```lua
---print(table.concat(meander.sensor.sonars(), ' '))
---```
---@return string[] # list of names
function meander.sensor.sonars() end

---A sonar model in detail: every effect with its switch.
---
---Fails on unknown name; a number out of range.
---
---```lua
---print(meander.sensor.sonar('real').dropout)
---```
---@param sonar meander.sonar_name|meander.sim.new.options.sonar its name, or a table that changes one
---@return table # table of options, as sim.new and scan take it
function meander.sensor.sonar(sonar) end

---Trials over seeds, and their statistics.
meander.study = {}

---@class meander.study.trials.options
---@field trial fun(seed: any, index: any): ...any function(seed, index) that returns a run, or a table, number or text
---@field seeds? integer[] one trial for each
---@field count? integer so many trials, with seeds that follow from `seed`; 0 when left out
---@field seed? integer from which the seeds of the trials follow; 1 when left out
---@field jobs? integer trials at a time, each in a process of its own; 0: one per core; 0 when left out

---Runs a function over seeds. Each trial has its own process, forked when its turn comes, and math.random is seeded with its seed: nothing carries over from trial to trial or back to the caller, and the number of jobs changes no result. Results come in the order of the seeds.
---
---Fails on neither seeds nor count; no process to be had.
---
---```lua
---r = meander.study.trials { seeds = {1, 2}, jobs = 1, trial = function(seed) return { twice = 2 * seed } end }
---print(r[2].value.twice)
---```
---@param options meander.study.trials.options the function and the seeds
---@return table[] # list of tables: seed, ok, and value (of a run: its figures) or error
function meander.study.trials(options) end

---The mean.
---
---Fails on an empty sample.
---
---```lua
---print(meander.study.mean {1, 2, 6})
---```
---@param values number[]|numbers a sample: list of numbers or a view
---@return number # number
function meander.study.mean(values) end

---The median.
---
---Fails on an empty sample.
---
---```lua
---print(meander.study.median {1, 2, 6})
---```
---@param values number[]|numbers a sample: list of numbers or a view
---@return number # number
function meander.study.median(values) end

---Share of successes with Wilson's score interval.
---
---Fails on more successes than trials; no trials.
---
---```lua
---print(meander.study.wilson(18, 20))
---```
---@param successes integer how many
---@param trials integer of how many
---@param confidence? number 0.95 when left out
---@return number # share, lower and upper end
---@return number
---@return number
function meander.study.wilson(successes, trials, confidence) end

---@class meander.study.bootstrap_mean.options
---@field confidence? number with which the interval holds the true value; 0.95 when left out
---@field resamples? integer samples drawn; 2000 when left out
---@field seed? integer seed of the draws; 1 when left out

---Mean with its bootstrap interval; the same seed gives the same.
---
---Fails on an empty sample.
---
---```lua
---print(meander.study.bootstrap_mean({1, 2, 6}, { seed = 3 }))
---```
---@param values number[]|numbers a sample: list of numbers or a view
---@param options? meander.study.bootstrap_mean.options confidence and resampling
---@return number # mean, lower and upper end
---@return number
---@return number
function meander.study.bootstrap_mean(values, options) end

---Median with its bootstrap interval; the same seed gives the same.
---
---Fails on an empty sample.
---
---```lua
---print(meander.study.bootstrap_median {1, 2, 6})
---```
---@param values number[]|numbers a sample: list of numbers or a view
---@param options? meander.study.bootstrap_mean.options confidence and resampling
---@return number # median, lower and upper end
---@return number
---@return number
function meander.study.bootstrap_median(values, options) end

---Two ways tried on the same seeds: mean difference with its bootstrap interval.
---
---Fails on samples of different size.
---
---```lua
---print(meander.study.compare({1, 2, 6}, {2, 2, 3}))
---```
---@param a number[]|numbers results of one way
---@param b number[]|numbers of the other, in the same order
---@param options? meander.study.bootstrap_mean.options confidence and resampling
---@return number # mean of a - b, lower and upper end, and how often a was larger, b was, neither
---@return number
---@return number
---@return integer
---@return integer
---@return integer
function meander.study.compare(a, b, options) end

---Sonar readings to grid maps: sensor models, networks, fusion, local and global maps.
meander.mapping = {}

---@alias meander.model_name 'nn1'|'nn2'|'nn3'|'nn4'|'nn5'|'elfes'|'ros'

---@class meander.mapping.map.options.elfes
---@field half_cone? number half opening angle of the cone [rad]; 0.218166 when left out
---@field depth? number half the depth of the shell around the range in which something echoed [m]; 0.075 when left out
---@field free? number how sure the axis of the cone is free near the sonar; 0.7 when left out
---@field occupied? number how sure the axis is occupied at the range; 0.95 when left out
---@field trust? number farther away a cone tells nothing [m]; 2 when left out

---@class meander.mapping.map.options.ros
---@field half_cone? number half opening angle of the cone [rad]; 0.26 when left out
---@field reliable? number distance at which readings lose half their weight [m]; 0.8 when left out
---@field tolerance? number half the depth of the shell, as a share of the range; 0.08 when left out
---@field clear_beyond? boolean no echo clears the cone; false when left out

---@alias meander.fusion_name 'viewbin'|'bayes'

---@class meander.mapping.map.options
---@field model? meander.model_name|sonar_model|sonar_network|fun(ranges: any, range: any, bearing: any): ...any what scans tell about cells: a name that meander.mapping.models() tells, 'nn4' when left out; a model, a network, or a function as meander.mapping.model takes it
---@field preset? string networks: sonar that their weights were trained for
---@field table? boolean networks: compiled to a lookup table, faster and a little worse; false when left out
---@field elfes? meander.mapping.map.options.elfes options of the model of this name
---@field ros? meander.mapping.map.options.ros options of the model of this name
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot whose sonars are read
---@field size? integer cells along a side of the local map; 60 when left out
---@field resolution? number side of a cell [m]; 0.05 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field fusion? meander.fusion_name viewbin: scans from about the same place count once; bayes: every scan counts, [CN] eq. (4); 'viewbin' when left out
---@field certainty? number probabilities stay between 1 minus this and this; 0.99 when left out
---@field view_bearing? number viewbin: bearings this near count as the same view of a cell [rad]; 0.785398 when left out
---@field view_range? number viewbin: distances this near count as the same view of a cell [m]; 1 when left out
---@field view_blend? number viewbin: weight of the newest scan in the opinion of its view; 0.3 when left out
---@field remember_views? boolean viewbin: a view come back to goes on from its opinion instead of counting anew; true when left out
---@field global? boolean keep a map of everywhere, too; true when left out

---A new, empty map: a local window that slides with the robot, and a global map.
---
---Fails on an unknown model; a number out of range.
---
---```lua
---print(meander.mapping.map { model = 'elfes', fusion = 'bayes' })
---```
---@param options? meander.mapping.map.options the sensor model, the robot, the fusion, size and cells
---@return map # the map
function meander.mapping.map(options) end

---The names of the sensor models.
---
---```lua
---print(table.concat(meander.mapping.models(), ' '))
---```
---@return string[] # list of names
function meander.mapping.models() end

---Takes in one scan.
---
---Fails on readings of another ring; a pose that is no place; a full global map.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(m.scans)
---```
---@param observation observation what the robot sees
function map:update(observation) end

---How probably a place is occupied; 0.5: unknown. By the local map where that knows something, else by the global map.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(m:probability(2, 2))
---```
---@param x number in the odometry frame [m]
---@param y number the same [m]
---@return number # the probability
function map:probability(x, y) end

---@alias meander.part_name 'local'|'global'

---A copy of the probabilities, the row of the least y first.
---
---Fails on there is no global map.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(m:matrix 'local')
---```
---@param part? meander.part_name 'local' or 'global'; the global map where there is one
---@return matrix # the probabilities
function map:matrix(part) end

---Where the matrix of the same part lies, in the odometry frame.
---
---Fails on there is no global map.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(m:bounds('local')[1].x)
---```
---@param part? meander.part_name 'local' or 'global'; the global map where there is one
---@return meander.box # its corners [m]
function map:bounds(part) end

---Writes a ROS map (.yaml and the .pgm beside it: free, unknown, occupied), which meander.world.import reads again, or the shades alone (.pgm, .png).
---
---Fails on another suffix; an empty map; a file that cannot be written.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---m:save('map.yaml')
---```
---@param path string a name with the suffix .yaml, .pgm or .png
---@param part? meander.part_name 'local' or 'global'; the global map where there is one
function map:save(path, part) end

---A picture of one part; show(map) draws the global map where there is one.
---
---Fails on an empty map; there is no global map.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(m:picture 'local')
---```
---@param part? meander.part_name 'local' or 'global'
---@return picture # the picture
function map:picture(part) end

---Forgets everything.
---
---```lua
---s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---m:clear()
---print(m.scans)
---```
function map:clear() end

---@class meander.mapping.model.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot whose sonars are read
---@field preset? string networks: sonar that their weights were trained for
---@field table? boolean networks: compiled to a lookup table, faster and a little worse; false when left out
---@field elfes? meander.mapping.map.options.elfes options of the model of this name
---@field ros? meander.mapping.map.options.ros options of the model of this name

---A sensor model: what one scan tells about cells. By name, from a network, or a function of one's own: it is given the ranges and lists of the cells' ranges [m] and bearings [rad] from the robot, and returns a list of log-odds.
---
---Fails on an unknown name; no weights for this sonar; another ring.
---
---```lua
---print(meander.mapping.model('nn4', { preset = 'real' }))
---```
---@param what meander.model_name|sonar_model|sonar_network|fun(ranges: any, range: any, bearing: any): ...any a name that models() tells, a network, or a function
---@param options? meander.mapping.model.options what it is for
---@return sonar_model # the model, as meander.mapping.map takes it
function meander.mapping.model(what, options) end

---What a scan tells about places; log-odds l are the probability 1 / (1 + exp(-l)), 0 is unknown.
---
---Fails on another number of ranges.
---
---```lua
---ranges = {}
---for i = 1, 16 do ranges[i] = 1.5 end
---print(meander.mapping.model('nn4'):evaluate(ranges, { {1, 0}, {1.75, 0} })[1])
---```
---@param ranges number[]|numbers one for each sonar, in ring order [m]
---@param cells meander.point[] places in the frame of the robot [m]
---@param range_max? number the range that stands for no echo; 6.477 when left out [m]
---@return number[] # list of the log-odds of each being occupied
function sonar_model:evaluate(ranges, cells, range_max) end

---How well single scans tell occupied from free; both classes weigh the same.
---
---Fails on lessons of another ring, or without cells of both kinds.
---
---```lua
---l = meander.mapping.lessons { worlds = { meander.world.open 'worlds/office.toml' }, poses = 4 }
---print(meander.mapping.model('elfes'):score(l).ce)
---```
---@param lessons lessons scans with cells whose truth is known
---@return table # table of figures
function sonar_model:score(lessons) end

---@class meander.mapping.lessons.options
---@field worlds world[] in which the robot looks around
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot: its body and where its sonars sit
---@field sonar? meander.sonar_name|meander.sim.new.options.sonar model of the sonars, by name or in detail
---@field poses? integer free places of the world from which the robot looks; 50 when left out
---@field window? integer cells along a side of the square around the robot; 60 when left out
---@field resolution? number side of a cell [m]; 0.05 when left out
---@field slack? number cells so far behind the first surface on the line of sight still count as seen [m]; 0.07 when left out
---@field occupied? number share of the occupied cells in sight that is taken; 0.25 when left out
---@field free? number share of the free cells in sight that is taken; 0.015 when left out
---@field hidden? number share of the hidden cells that is taken; 0.008 when left out
---@field seed? integer of poses, sonars and the choice of cells; 1 when left out

---Puts a robot at random free poses of worlds, reads its sonars there, and notes cells around it: occupied, free, or hidden from its sight. Networks learn from that, and models are measured by it. Of each kind a share is taken.
---
---Fails on no world; a world without room; a number out of range.
---
---```lua
---l = meander.mapping.lessons { worlds = { meander.world.open 'worlds/office.toml' }, poses = 5 }
---print(l)
---```
---@param options meander.mapping.lessons.options the worlds, the robot with its sonars, how many poses and cells
---@return lessons # the lessons
function meander.mapping.lessons(options) end

---@alias meander.method_name 'adam'|'backprop'

---@class meander.mapping.train.options
---@field lessons lessons what to learn from
---@field validation? lessons what to measure on after each epoch, from other worlds
---@field network? string what it is told: 'nn1', 'nn2', 'nn3' of the paper, 'nn4' or 'nn5'
---@field method? meander.method_name adam: cross-entropy; backprop: the paper's, squared error down the gradient; 'adam' when left out
---@field hidden? integer[] units of each hidden layer
---@field epochs? integer times that every example is seen; 40 when left out
---@field batch? integer examples to a step; 256 when left out
---@field rate? number of learning; 0: 0.02 for adam, 0.3 for backprop; 0 when left out
---@field momentum? number backprop: share of the last step that is taken again; 0.9 when left out
---@field balanced? boolean occupied and free examples weigh the same, however many there are; true when left out
---@field unknown? number weight of hidden examples, against that of all others together; 0.25 when left out
---@field seed? integer of the first weights and of the order of the examples; 1 when left out
---@field on_epoch? fun(epoch: any): ...any function(epoch) called after each: epoch, epochs, training, validation
---@field show? boolean shows the loss on the terminal while it learns; false when left out
---@field sonar? string for the file: the sonar that it is for, in words
---@field made_by? string for the file: what made it, in words

---Trains a network from random weights; the same lessons and options give the same.
---
---Fails on lessons without occupied or free cells; a number out of range; words of several lines.
---
---```lua
---l = meander.mapping.lessons { worlds = { meander.world.open 'worlds/office.toml' }, poses = 5 }
---n = meander.mapping.train { lessons = l, hidden = {4}, epochs = 2 }
---print(meander.mapping.model(n):score(l).ce)
---```
---@param options meander.mapping.train.options the lessons, the kind of network and how it learns
---@return sonar_network # the network
function meander.mapping.train(options) end

---Reads the weights of a network, e.g. of one that comes with the program.
---
---Fails on no such file; a file cut short or damaged, weights that are no numbers, layers that do not fit.
---
---```lua
---print(meander.mapping.network 'models/nn4_ideal.txt')
---```
---@param path string a .txt file
---@return sonar_network # the network
function meander.mapping.network(path) end

---Writes the weights as text, with a checksum.
---
---Fails on the file cannot be written.
---
---```lua
---l = meander.mapping.lessons { worlds = { meander.world.open 'worlds/office.toml' }, poses = 5 }
---n = meander.mapping.train { lessons = l, hidden = {4}, epochs = 2 }
---n:save 'mine.txt'
---print(meander.mapping.network 'mine.txt')
---```
---@param path string a name with the suffix .txt
function sonar_network:save(path) end

---@class meander.study.map_score.options
---@field slack? number cells so far behind the first surface on the line of sight still count as seen [m]; 0.07 when left out
---@field directions? integer in which the distance to the first obstacle is compared; 72 when left out
---@field threshold? number probability above which a cell is an obstacle in these directions; 0.5 when left out
---@field bins? integer of the reliability curve; 10 when left out

---How good the local map of the first robot is, on the cells that it sees from where it is; both classes weigh the same. Odometry must not drift.
---
---Fails on an option out of range.
---
---```lua
---w = meander.world.new { start = {2, 2, 0} }
---w:add_disc { center = {3, 2}, radius = 0.3 }
---s = meander.sim.new { world = w }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(meander.study.map_score(m, s).error)
---```
---@param map map which
---@param sim sim the truth
---@param options? meander.study.map_score.options how it is scored
---@return table # table of figures
function meander.study.map_score(map, sim, options) end

---@class meander.study.map_truth.options
---@field slack? number cells so far behind the first surface on the line of sight still count as seen [m]; 0.07 when left out

---What the cells of the local map truly are for the first robot: 0 hidden, 1 free, 2 occupied, in the shape of map:matrix 'local'.
---
---Fails on an option out of range.
---
---```lua
---w = meander.world.new { start = {2, 2, 0} }
---w:add_disc { center = {3, 2}, radius = 0.3 }
---s = meander.sim.new { world = w }
---m = meander.mapping.map { model = 'elfes' }
---m:update(s.observation)
---print(meander.study.map_truth(m, s):all():max())
---```
---@param map map which
---@param sim sim the truth
---@param options? meander.study.map_truth.options what counts as seen
---@return matrix # the truth
function meander.study.map_truth(map, sim, options) end

---@class meander.autonomy.map_navigator.options.map
---@field model? meander.model_name|sonar_model|sonar_network|fun(ranges: any, range: any, bearing: any): ...any what scans tell about cells: a name that meander.mapping.models() tells, 'nn4' when left out; a model, a network, or a function as meander.mapping.model takes it
---@field preset? string networks: sonar that their weights were trained for
---@field table? boolean networks: compiled to a lookup table, faster and a little worse; false when left out
---@field elfes? meander.mapping.map.options.elfes options of the model of this name
---@field ros? meander.mapping.map.options.ros options of the model of this name
---@field size? integer cells along a side of the local map; 104 when left out
---@field resolution? number side of a cell [m]; 0.05 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field fusion? meander.fusion_name viewbin: scans from about the same place count once; bayes: every scan counts, [CN] eq. (4); 'viewbin' when left out
---@field certainty? number probabilities stay between 1 minus this and this; 0.99 when left out
---@field view_bearing? number viewbin: bearings this near count as the same view of a cell [rad]; 0.785398 when left out
---@field view_range? number viewbin: distances this near count as the same view of a cell [m]; 1 when left out
---@field view_blend? number viewbin: weight of the newest scan in the opinion of its view; 0.3 when left out
---@field remember_views? boolean viewbin: a view come back to goes on from its opinion instead of counting anew; true when left out

---@class meander.autonomy.map_navigator.options.polar
---@field mode? meander.mode_name with the remedies beyond the paper, or without them: then their options are refused; 'full' when left out
---@field map? meander.polar.navigator.options.map the polar map
---@field memory? meander.polar.navigator.options.memory the short-term memory
---@field prediction? meander.polar.navigator.options.prediction prediction of the configuration
---@field solver? meander.polar.navigator.options.solver how the equilibrium is found
---@field subgoal? meander.polar.navigator.options.subgoal how the subgoal is read off
---@field control? meander.polar.navigator.options.control motion control
---@field trap? meander.polar.navigator.options.trap trapped: when, and what then

---@class meander.autonomy.map_navigator.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field map? meander.autonomy.map_navigator.options.map the local map from which it takes its obstacles
---@field polar? meander.autonomy.map_navigator.options.polar the polar navigator
---@field occupied? number cells of at least this probability are obstacles; 0.5 when left out

---The polar navigator that takes its obstacles from a local map instead of single readings.
---
---Fails on an unknown model; a number out of range.
---
---```lua
---print(meander.autonomy.map_navigator { map = { model = 'elfes' }, occupied = 0.6 })
---```
---@param options? meander.autonomy.map_navigator.options the robot, the map, the navigator
---@return navigator # the navigator
function meander.autonomy.map_navigator(options) end

---@class meander.autonomy.map_safety.options.map
---@field model? meander.model_name|sonar_model|sonar_network|fun(ranges: any, range: any, bearing: any): ...any what scans tell about cells: a name that meander.mapping.models() tells, 'nn4' when left out; a model, a network, or a function as meander.mapping.model takes it
---@field preset? string networks: sonar that their weights were trained for
---@field table? boolean networks: compiled to a lookup table, faster and a little worse; false when left out
---@field elfes? meander.mapping.map.options.elfes options of the model of this name
---@field ros? meander.mapping.map.options.ros options of the model of this name
---@field size? integer cells along a side of the local map; 60 when left out
---@field resolution? number side of a cell [m]; 0.05 when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field fusion? meander.fusion_name viewbin: scans from about the same place count once; bayes: every scan counts, [CN] eq. (4); 'viewbin' when left out
---@field certainty? number probabilities stay between 1 minus this and this; 0.99 when left out
---@field view_bearing? number viewbin: bearings this near count as the same view of a cell [rad]; 0.785398 when left out
---@field view_range? number viewbin: distances this near count as the same view of a cell [m]; 1 when left out
---@field view_blend? number viewbin: weight of the newest scan in the opinion of its view; 0.3 when left out
---@field remember_views? boolean viewbin: a view come back to goes on from its opinion instead of counting anew; true when left out

---@class meander.autonomy.map_safety.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that is driven
---@field map? meander.autonomy.map_safety.options.map the local map that stops it
---@field margin? number no command may lead the hull nearer to an occupied cell than this [m]; 0.03 when left out
---@field occupied? number cells of at least this probability are obstacles; 0.5 when left out

---A navigator whose commands are slowed down where a local map shows something in the way.
---
---Fails on an unknown model; a number out of range.
---
---```lua
---print(meander.autonomy.map_safety(meander.polar.potential_field {}, { map = { model = 'elfes' } }))
---```
---@param navigator meander.navigator_name|navigator|fun(observation: observation, subgoal: any): ...any|table<string, function> who drives, as sim:drive takes it
---@param options? meander.autonomy.map_safety.options the robot, the map, how near it may get
---@return navigator # the navigator
function meander.autonomy.map_safety(navigator, options) end

---@alias meander.bad_name 'skip'|'refuse'

---@class meander.study.sonar_log.options
---@field bad? meander.bad_name records that cannot be right: skip and count them, or refuse the file; 'skip' when left out
---@field range_max? number a reading from here on is no echo [m]; 6.477 when left out
---@field range_possible? number a reading above this, below 0 or no number is impossible; skipped as no echo [m]; 30 when left out

---Reads recorded scans with poses: a table (.csv, such as run:save writes; with contacts and light where it has them) or a log of CARMEN (.log, .clf, .carmen).
---
---Fails on a file that is no log; with bad = 'refuse' the first record that cannot be right.
---
---```lua
---f = io.open('log.csv', 'w')
---f:write('time,x,y,heading,s1,s2,s3,s4\n0,0,0,0,1,2,1,2\n1,0.1,0,0,0.9,2,1.1,2\n')
---f:close()
---l = meander.study.sonar_log 'log.csv'
---print(l, l[2].pose)
---```
---@param path string a file with the suffix .csv, .log, .clf or .carmen
---@param options? meander.study.sonar_log.options what becomes of records that cannot be right
---@return sonar_log # the log: log[i] is an observation, #log their number
function meander.study.sonar_log(path, options) end

---Global planning on maps of cells: neural maps and their peers.
meander.planning = {}

---@alias meander.planning.map.options.unknown 'blocked'|'free'|'costly'

---@class meander.planning.map.options
---@field map? grid_map a map of meander.planning.map or read_map
---@field world? world or a world: its obstacles and closed doors as cells
---@field sonar_map? map or a map that a robot has built
---@field cells? matrix|number[][] or rows of probabilities that a cell is solid, the lowest row first; not a number: unknown
---@field resolution? number side of a cell, of worlds and rows [m]; 0.05 when left out
---@field origin? meander.point of rows: lower left corner [m]
---@field occupied? number cells of at least this probability are solid; 0.65 when left out
---@field vacant? number cells of at most this probability are free; between the two they are unknown; 0.35 when left out
---@field unknown? meander.planning.map.options.unknown what becomes of unknown cells; 'blocked' when left out
---@field unknown_cost? number difficulty of unknown cells where they are costly; 4 when left out

---A map of cells to plan on. Edits of it do not change what it was made from.
---
---Fails on none or several sources; a number out of range.
---
---```lua
---print(meander.planning.map { cells = { {0, 0, 1}, {0, 0.5, 0} } })
---```
---@param options? meander.planning.map.options what it is made from
---@return grid_map # the map
function meander.planning.map(options) end

---Reads a map of movingai.com cell by cell.
---
---Fails on no such file; what is wrong in it, with the line.
---
---```lua
---f = os.tmpname()
---io.open(f, 'w'):write('type octile\nheight 1\nwidth 3\nmap\n.@.\n'):close()
---print(meander.planning.read_map(f))
---```
---@param path string a .map file
---@param resolution? number side of a cell; 1 when left out [m]
---@return grid_map # the map
function meander.planning.read_map(path, resolution) end

---Reads the tasks that movingai.com publishes for this map.
---
---Fails on no such file; another map's size; what is wrong in it, with the line.
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 1 }
---f = os.tmpname()
---io.open(f, 'w'):write('version 1\n0 x 8 4 0 0 3 0 3\n'):close()
---print(m:scenarios(f)[1].length)
---```
---@param path string a .scen file
---@return table[] # list of tasks: start, goal, length, bucket
function grid_map:scenarios(path) end

---Puts something solid over all cells whose centres lie in a box, or takes it away.
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 1 }
---m:block {{3, 0}, {4, 3}}
---print(m:solid(3.5, 1.5))
---```
---@param box meander.box where [m]
---@param solid? boolean false takes it away
function grid_map:block(box, solid) end

---How hard it is to go through the cells of a box: cost of a way, for its length.
---
---Fails on a number that is not from 0.001 to 1000.
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 1 }
---m:set_difficulty({{3, 0}, {4, 3}}, 5)
---print(m)
---```
---@param box meander.box where [m]
---@param difficulty number 1 is usual; below 1: preferred
function grid_map:set_difficulty(box, difficulty) end

---Inclines and preferred ways: a way in direction u costs 1 + drag . u times as much.
---
---Fails on a longer vector.
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 1 }
---m:set_drag({{3, 0}, {4, 3}}, {0.5, 0})
---print(m)
---```
---@param box meander.box where [m]
---@param drag meander.point uphill; of length up to 0.999
function grid_map:set_drag(box, drag) end

---Does something solid stand there?
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 1 }
---print(m:solid(3.5, 1.5))
---```
---@param x number where [m]
---@param y number where [m]
---@return boolean # true in solid cells and outside of the map
function grid_map:solid(x, y) end

---@alias meander.path_name 'gradient'|'steepest'|'slope'|'log_slope'

---@alias meander.corners_name 'keep'|'cut'

---@alias meander.lattice_name 'rectangular'|'wide'|'hexagonal'

---@alias meander.solver_name 'tiles'|'active_list'|'raster'|'synchronous'

---@alias meander.extent_name 'map'|'start'

---@alias meander.planning.plan.options.weights 'inverse'|'gaussian'

---@alias meander.planning.plan.options.harmonic.solver 'exact'|'sor'

---@class meander.planning.plan.options.harmonic
---@field solver? meander.planning.plan.options.harmonic.solver how the harmonic function is found; 'exact' when left out
---@field tolerance? number largest relative change of a cell in a sweep at the end (sor); 1e-06 when left out

---@class meander.planning.plan.options
---@field map? grid_map a map of meander.planning.map or read_map
---@field world? world or a world: its obstacles and closed doors as cells
---@field sonar_map? map or a map that a robot has built
---@field cells? matrix|number[][] or rows of probabilities that a cell is solid, the lowest row first; not a number: unknown
---@field resolution? number side of a cell, of worlds and rows [m]; 0.05 when left out
---@field origin? meander.point of rows: lower left corner [m]
---@field occupied? number cells of at least this probability are solid; 0.65 when left out
---@field vacant? number cells of at most this probability are free; between the two they are unknown; 0.35 when left out
---@field unknown? meander.planning.map.options.unknown what becomes of unknown cells; 'blocked' when left out
---@field unknown_cost? number difficulty of unknown cells where they are costly; 4 when left out
---@field planner? string who plans: neural_map, distance_transform, harmonic, astar or theta_star
---@field start? string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any } where from; left out: the landscape alone [m]
---@field target? string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any } where to [m]
---@field targets? (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to, several: to the one that is best [m]
---@field path? meander.path_name how the path is read off the landscape; 'gradient' when left out
---@field robot_radius? number what is solid is kept this far from the path [m]; 0 when left out
---@field corners? meander.corners_name may diagonal steps pass the corner of a blocked cell; 'keep' when left out
---@field lattice? meander.lattice_name which cells are neighbours; 'rectangular' when left out
---@field solver? meander.solver_name how the equilibrium is found; 'tiles' when left out
---@field extent? meander.extent_name solve the whole map, or what the path from the start needs; 'map' when left out
---@field extra_patterns? integer raster and synchronous with extent start: so many patterns more than the front needs; 0 when left out
---@field weights? meander.planning.plan.options.weights weight of a connection of cost rho: 1 / rho or exp(-gamma rho^2); 'inverse' when left out
---@field gamma? number of gaussian weights; 0.5 when left out
---@field steepness? number beta times the largest sum of a unit's weights; 0.68 is the paper's beta of 0.1; 0.68 when left out
---@field tolerance? number largest relative error of a unit's equation at the end; 1e-06 when left out
---@field threads? integer of the tiles solver; 0: all cores; the same landscape with any number; 1 when left out
---@field harmonic? meander.planning.plan.options.harmonic options of the harmonic function

---Plans a path on a map of cells.
---
---Fails on no target; an unknown planner; a number out of range.
---
---```lua
---p = meander.planning.plan { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5, start = {1, 1}, target = {7, 3} }
---print(p)
---```
---@param options? meander.planning.plan.options the map, where from, where to, and who plans how
---@return plan|nil # the plan; or nil and why there is no path
---@return string|nil
function meander.planning.plan(options) end

---The names that plan takes as planner.
---
---```lua
---print(meander.planning.planners()[1])
---```
---@return string[] # list of names
function meander.planning.planners() end

---A path on the same landscape from another start, or read off in another way.
---
---Fails on a plan of a search, which has no landscape; another start than that of an extent = 'start'.
---
---```lua
---p = meander.planning.plan { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5, start = {1, 1}, target = {7, 3} }
---print(p:from({1, 3}, 'steepest'))
---```
---@param start meander.point where from [m]
---@param kind? meander.path_name how it is read off; as before when left out
---@return plan|nil # the plan; or nil and why there is no path
---@return string|nil
function plan:from(start, kind) end

---The landscape at a point: ln v of a neural map, minus the cost that is left [cells], or the logarithm of a harmonic function.
---
---```lua
---p = meander.planning.plan { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5, start = {1, 1}, target = {7, 3} }
---print(p:value(2, 2))
---```
---@param x number where [m]
---@param y number where [m]
---@return number|nil # the value; nil where there is none
function plan:value(x, y) end

---All values in single precision, the lowest row first; -inf where there is none.
---
---```lua
---p = meander.planning.plan { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5, start = {1, 1}, target = {7, 3} }
---print(p:landscape().rows)
---```
---@return matrix # a matrix
function plan:landscape() end

---@class meander.planning.replanner.options
---@field map grid_map a map of meander.planning.map or read_map, whose edits are followed
---@field start? string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any } where from; left out: the landscape alone [m]
---@field target? string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any } where to [m]
---@field targets? (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to, several: to the one that is best [m]
---@field path? meander.path_name how the path is read off the landscape; 'gradient' when left out
---@field robot_radius? number what is solid is kept this far from the path [m]; 0 when left out
---@field corners? meander.corners_name may diagonal steps pass the corner of a blocked cell; 'keep' when left out
---@field lattice? meander.lattice_name which cells are neighbours; 'rectangular' when left out
---@field solver? meander.solver_name how the equilibrium is found; 'tiles' when left out
---@field weights? meander.planning.plan.options.weights weight of a connection of cost rho: 1 / rho or exp(-gamma rho^2); 'inverse' when left out
---@field gamma? number of gaussian weights; 0.5 when left out
---@field steepness? number beta times the largest sum of a unit's weights; 0.68 is the paper's beta of 0.1; 0.68 when left out
---@field tolerance? number largest relative error of a unit's equation at the end; 1e-06 when left out
---@field threads? integer of the tiles solver; 0: all cores; the same landscape with any number; 1 when left out

---A neural map that follows the edits of its map: only what changes is computed (with difficulty or drag, all), and the landscape is that of a solve from scratch, to the tolerance.
---
---Fails on no map, no target; a number out of range; the solvers raster and synchronous.
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5 }
---r = meander.planning.replanner { map = m, start = {1, 1}, target = {7, 1} }
---print(r)
---```
---@param options meander.planning.replanner.options the map, where from and where to, and how
---@return replanner # the replanner
function meander.planning.replanner(options) end

---The plan on the map as it is now; its statistics tell the updates of this edit alone.
---
---```lua
---m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5 }
---r = meander.planning.replanner { map = m, start = {1, 1}, target = {7, 1} }
---m:block {{3, 0}, {4, 3}}
---print(r:replan())
---```
---@return plan|nil # the plan; or nil and why there is no path
---@return string|nil
function replanner:replan() end

---@class meander.autonomy.planned_route.options
---@field map? grid_map a map of meander.planning.map or read_map
---@field world? world or a world: its obstacles and closed doors as cells
---@field sonar_map? map or a map that a robot has built
---@field cells? matrix|number[][] or rows of probabilities that a cell is solid, the lowest row first; not a number: unknown
---@field resolution? number side of a cell, of worlds and rows [m]; 0.05 when left out
---@field origin? meander.point of rows: lower left corner [m]
---@field occupied? number cells of at least this probability are solid; 0.65 when left out
---@field vacant? number cells of at most this probability are free; between the two they are unknown; 0.35 when left out
---@field unknown? meander.planning.map.options.unknown what becomes of unknown cells; 'blocked' when left out
---@field unknown_cost? number difficulty of unknown cells where they are costly; 4 when left out
---@field target? string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any } where to [m]
---@field targets? (string|thing|meander.point|{ x?: any, y?: any, tolerance?: any, heading?: any, name?: any })[] where to, several: to the one that is best [m]
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot: what its sonars hear and the map does not show is gone round, too, and robot_radius is that of its body
---@field planner? string who plans: neural_map, distance_transform, harmonic, astar or theta_star
---@field robot_radius? number of the robot's body [m]; 0.3 when left out
---@field margin? number kept from what is solid besides; given up where no path has it [m]; 0.1 when left out
---@field reach? number a subgoal is at most this far ahead on the path, and in sight on the map [m]; 3 when left out
---@field hand_over? number the next subgoal when this near [m]; 0.6 when left out
---@field tolerance? number of the target [m]; 0.25 when left out
---@field detour? number trapped is also who has driven this much more than the straight way to the subgoal [m]; 3 when left out
---@field replans? integer so often a new path is planned because the robot was trapped; 12 when left out
---@field trap_size? number side of the square that is taken as blocked where a trapped robot came no nearer [m]; 0.5 when left out
---@field mapped? number what the sonars hear this near to something solid in the map is taken to be that [m]; 0.2 when left out

---A guide: plans a path on a map of cells and hands its points to the navigator, each the farthest in sight. Plans anew when the navigator is trapped, with what is ahead taken as blocked, and when an edit of the map, or what the robot's sonars hear, blocks the rest of the path. It sees the map and the readings, never the world.
---
---Fails on no target; none or several maps; a number out of range.
---
---```lua
---w = meander.world.new { bounds = {{0, 0}, {8, 4}}, start = {1, 2, 0} }
---g = meander.autonomy.planned_route { world = w, target = {6, 2} }
---print(meander.sim.new({ world = w }):drive { navigator = 'potential_field', guide = g })
---```
---@param options? meander.autonomy.planned_route.options the map, where to, and how
---@return guide # the guide
function meander.autonomy.planned_route(options) end

---Exploration with indicators and the neural shortest path.
meander.indicator = {}

---An empty graph of indicators.
---
---```lua
---g = meander.indicator.graph()
---print(g)
---```
---@return indicator_graph # the graph
function meander.indicator.graph() end

---Reads a graph that graph:save wrote.
---
---Fails on the file cannot be read, or is none.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---f = os.tmpname()
---g:save(f)
---print(meander.indicator.open_graph(f))
---```
---@param path string the file
---@return indicator_graph # the graph
function meander.indicator.open_graph(path) end

---Reads a graph from the text that graph.source gives.
---
---Fails on a line that is wrong.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---print(meander.indicator.graph_from_text(g.source))
---```
---@param text string lines 'indicator', 'port', 'free', 'link'
---@return indicator_graph # the graph
function meander.indicator.graph_from_text(text) end

---Places an indicator.
---
---Fails on a number that is not finite.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---print(a)
---```
---@param position meander.point where, in the odometry frame [m]
---@return indicator # the indicator
function indicator_graph:place(position) end

---The indicator nearest to a position: the storage's winner.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---print(g:nearest {2, 0})
---```
---@param position meander.point where [m]
---@return indicator|nil # the indicator, or nil in an empty graph
function indicator_graph:nearest(position) end

---Writes it: .dot, .graphml and .json for other programs, else for open_graph.
---
---Fails on the file cannot be written.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---g:save(os.tmpname() .. '.dot')
---```
---@param path string the file
function indicator_graph:save(path) end

---The picture of a world with the graph over it, and the way that was driven.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---show(g:over(meander.world.new {}))
---```
---@param world world in whose frame the indicators are
---@param run? run the drive; none when left out
---@return picture # the picture, for show and save
function indicator_graph:over(world, run) end

---Gives it one more motion direction, of which nothing is known yet.
---
---Fails on a number that is not finite.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---print(a:add_port(0))
---```
---@param direction number in the odometry frame [rad]
---@param reach? number seen open so far; 1 when left out [m]
---@return integer # the port's number
function indicator:add_port(direction, reach) end

---Ties a port to one of another indicator; what they led to before is forgotten.
---
---Fails on a length that is not above 0; another graph; the same port twice.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---a:link(nil, b, nil, 3)
---```
---@param port? integer its own; nil: by sight, without a port
---@param to indicator the other indicator
---@param to_port? integer of that one; nil: by sight
---@param length number of the way [m]
function indicator:link(port, to, to_port, length) end

---The way was found closed: its link goes, the ports at both ends count as blocked.
---
---Fails on there is no such port.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---a:block(1)
---print(b.ports[1].state)
---```
---@param port integer its number
function indicator:block(port) end

---The way leads nowhere: the port counts as a dead end.
---
---Fails on there is no such port.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---b:give_up(1)
---print(b.ports[1].state)
---```
---@param port integer its number
function indicator:give_up(port) end

---A blocked port or dead end is unknown again.
---
---Fails on there is no such port.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---a:block(1)
---a:reopen(1)
---print(a.ports[1].state)
---```
---@param port integer its number
function indicator:reopen(port) end

---Takes it out of the graph, with its links.
---
---Fails on it was removed already.
---
---```lua
---g = meander.indicator.graph()
---a, b = g:place {0, 0}, g:place {3, 0}
---a:link(a:add_port(0), b, b:add_port(math.pi), 3.2)
---a:remove()
---print(a.alive, #g)
---```
function indicator:remove() end

---@alias meander.explorer_name 'indicator'|'tremaux'|'depth_first'|'nearest'|'goal_frontier'|'random_walk'

---@alias meander.rules_name 'literal'|'repaired'|'optimistic'

---@alias meander.rows_name 'paper'|'adaptive'

---@class meander.indicator.explorer.options
---@field goal meander.point where to, in the odometry frame [m]
---@field explorer? meander.explorer_name who decides: the indicators' rules, or a baseline on the same graph; 'indicator' when left out
---@field rules? meander.rules_name the paper's rules literally, repaired, or optimistic; 'optimistic' when left out
---@field eps? number stop looking when nothing unknown can shorten the route by more than this share; 0.01 when left out
---@field weight? number of the estimated way to the goal, until a route to it is known; 1 when left out
---@field step? number of a way that is not known, so much is taken to lead straight on [m]; 0.8 when left out
---@field rows? meander.rows_name of the network: as many as the paper says, or as many as it takes; 'adaptive' when left out
---@field tolerance? number the goal is reached when so near [m]; 0.3 when left out
---@field same? number an indicator that is so near is the one here [m]; 0.35 when left out
---@field match? number a port seen in a direction that is off by so little is the one stored [rad]; 0.6 when left out
---@field evidence? integer visits in a row without a port to be seen until it counts as closed; 1 when left out
---@field tries? integer failed approaches until a port is given up; 2 when left out
---@field recheck? integer runs until a closed way is tried again, twice as many each time; 0: never; 3 when left out
---@field decisions? integer budget of a run; 1000000 when left out
---@field budget? number budget of a run; 0: none [m]; 0 when left out
---@field seed? integer of the random walk; 1 when left out
---@field on_indicator? fun(indicator: indicator): ...any function(indicator), called when one was placed: {serial, x, y, run}
---@field on_decision? fun(decision: any): ...any function(decision), called after each step

---Explores with indicators: told at each crossing and dead end what there is, it says where to go.
---
---Fails on a number out of range.
---
---```lua
---print(meander.indicator.explorer { goal = {5, 5}, rules = 'repaired', on_indicator = print })
---```
---@param options meander.indicator.explorer.options where to, by which rules
---@return explorer # the explorer
function meander.indicator.explorer(options) end

---@class meander.indicator.open_explorer.options
---@field on_indicator? fun(indicator: indicator): ...any function(indicator), called when one was placed: {serial, x, y, run}
---@field on_decision? fun(decision: any): ...any function(decision), called after each step

---Reads an explorer that explorer:save wrote; it goes on as if nothing had been.
---
---Fails on the file cannot be read, or is none.
---
---```lua
---e = meander.indicator.explorer { goal = {5, 0} }
---d = e:step { position = {0, 0}, ports = { { direction = 0, reach = 3 } } }
---f = os.tmpname()
---e:save(f)
---print(meander.indicator.open_explorer(f))
---```
---@param path string the file
---@param options? meander.indicator.open_explorer.options functions that it calls, for they are not in the file
---@return explorer # the explorer
function meander.indicator.open_explorer(path, options) end

---A run begins: the robot was set down at its start. What is known stays known.
---
---```lua
---e = meander.indicator.explorer { goal = {5, 0} }
---e:begin()
---print(e.state.run)
---```
function explorer:begin() end

---@class explorer.step.percept.ports
---@field direction number in the odometry frame [rad]
---@field reach? number open so far, as far as it can be seen [m]; 1 when left out

---@class explorer.step.percept
---@field position meander.point where the robot stands, in the odometry frame [m]
---@field ports? explorer.step.percept.ports[] ways out of here: {direction, reach}
---@field back? number direction of the way it came by; nil: it was set down here [rad]
---@field walked? number since the last decision [m]; 0 when left out
---@field blocked? boolean it cannot go on, wherever this is; false when left out

---One decision, at a crossing, a dead end, an indicator, or where the way is closed.
---
---Fails on the run is over.
---
---```lua
---e = meander.indicator.explorer { goal = {5, 0} }
---d = e:step { position = {0, 0}, ports = { { direction = 0, reach = 3 } } }
---print(d.direction, d.reason)
---```
---@param percept explorer.step.percept what the robot perceives there
---@return table # ending, reason, at, direction, to, back, target, target_port, run, walked, decisions
function explorer:step(percept) end

---Writes it with its graph, for open_explorer.
---
---Fails on the file cannot be written.
---
---```lua
---e = meander.indicator.explorer { goal = {5, 0} }
---d = e:step { position = {0, 0}, ports = { { direction = 0, reach = 3 } } }
---e:save(os.tmpname())
---```
---@param path string the file
function explorer:save(path) end

---A copy of its graph as it is now.
---
---```lua
---e = meander.indicator.explorer { goal = {5, 0} }
---d = e:step { position = {0, 0}, ports = { { direction = 0, reach = 3 } } }
---show(e:graph())
---```
---@return indicator_graph # the graph
function explorer:graph() end

---The known route from the start of the last run to the goal.
---
---```lua
---e = meander.indicator.explorer { goal = {5, 0} }
---d = e:step { position = {0, 0}, ports = { { direction = 0, reach = 3 } } }
---print(e:route())
---```
---@return (integer|nil)[] # serial numbers and length [m]; nil: none is known
---@return number|nil
function explorer:route() end

---@alias meander.strategy_name 'indicators'|'dstar_lite'|'frontier'|'goal_frontier'

---@alias meander.perception_name 'map'|'profile'

---@class meander.indicator.sonar_explorer.options.map
---@field resolution? number side of a cell [m]; 0.05 when left out
---@field half_cone? number half opening angle of a sonar's cone [rad]; 0.218166 when left out
---@field range? number what is farther away counts for nothing [m]; 3 when left out
---@field arcs? number echoes from farther away are no walls [m]; 1.3 when left out
---@field silent? number a reading from here on is no echo [m]; 6.4 when left out
---@field silence? number where nothing echoes it is free so far [m]; 3 when left out
---@field moved? number a scan counts when the robot has moved so far since the last [m]; 0.045 when left out
---@field margin? number kept from walls beside the robot's radius [m]; 0.025 when left out
---@field hard? number a wall with more evidence than this is certain, and hardly worn away; 6 when left out
---@field suspect? number with more evidence than this a wall is suspected, and nothing expected behind; 0.6 when left out
---@field room? number ways leave so much more beside them, where they can [m]; 0.225 when left out

---@class meander.indicator.sonar_explorer.options.ports
---@field ball? number what is so near by a free way belongs to an indicator: 1.25 corridor widths [m]; 1.25 when left out
---@field shell? number thickness of the ball's shell, in which ports are sought [m]; 0.12 when left out
---@field piece? number a wider piece of the shell is cut [m]; 0.9 when left out
---@field cells? integer least number of cells of a port; 3 when left out
---@field window? number so far around an indicator is looked for what lies behind a port [m]; 4 when left out

---@class meander.indicator.sonar_explorer.options.profile
---@field memory? number echoes are kept for so much way [m]; 2 when left out
---@field range? number what is farther away counts for nothing [m]; 3 when left out
---@field through? number an echo is forgotten when a later beam through it reads so much more [m]; 0.06 when left out
---@field beam? number half opening angle within which a beam goes through an echo [rad]; 0.11 when left out
---@field directions? integer in so many directions it is asked how far the robot could drive; 72 when left out
---@field slim? number the robot is taken to be narrower by so much: cones show walls nearer to their axis [m]; 0.08 when left out
---@field open? number a direction is open when the robot could drive so far, or, in wide places, farther [m]; 0.8 when left out
---@field least? number a narrower interval of open directions is none [rad]; 0.17 when left out
---@field most? number a wider interval is cut [rad]; 1.3 when left out

---@class meander.indicator.sonar_explorer.options.sight
---@field near? number indicators within this of the robot have their ports told anew [m]; 3.2 when left out
---@field link? number indicators with a free way of at most this between them are linked [m]; 3 when left out
---@field keep? number a port that is so near to one given up before is given up [m]; 0.3 when left out

---@class meander.indicator.sonar_explorer.options
---@field goal meander.point where to, in the odometry frame [m]
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot
---@field strategy? meander.strategy_name who chooses: the indicators; D* Lite's shortest way with unknown as free; the frontier nearest to the robot, or nearest on the way to the goal; 'indicators' when left out
---@field perception? meander.perception_name what ports are read off: the accumulated map, or, as in the paper, the polar profile of the place; 'map' when left out
---@field explorer? meander.explorer_name who decides: the indicators' rules, or a baseline on the same graph; 'indicator' when left out
---@field rules? meander.rules_name the paper's rules literally, repaired, or optimistic; 'optimistic' when left out
---@field eps? number stop looking when nothing unknown can shorten the route by more than this share; 0.01 when left out
---@field weight? number of the estimated way to the goal, until a route to it is known; 1 when left out
---@field step? number of a way that is not known, so much is taken to lead straight on [m]; 0.8 when left out
---@field rows? meander.rows_name of the network: as many as the paper says, or as many as it takes; 'adaptive' when left out
---@field tolerance? number the goal is reached when so near [m]; 0.3 when left out
---@field same? number an indicator that is so near is the one here [m]; 0.3 when left out
---@field match? number a port seen in a direction that is off by so little is the one stored [rad]; 0.6 when left out
---@field evidence? integer visits in a row without a port to be seen until it counts as closed; 2 when left out
---@field tries? integer failed approaches until a port is given up; 2 when left out
---@field recheck? integer runs until a closed way is tried again, twice as many each time; 0: never; 3 when left out
---@field decisions? integer budget of a run; 20000 when left out
---@field budget? number budget of a run; 0: none [m]; 0 when left out
---@field seed? integer of the random walk; 1 when left out
---@field map? meander.indicator.sonar_explorer.options.map the map that the sonars make
---@field ports? meander.indicator.sonar_explorer.options.ports how ports are read off the map
---@field profile? meander.indicator.sonar_explorer.options.profile how ports are read off the polar profile
---@field sight? meander.indicator.sonar_explorer.options.sight of which indicators the map is asked
---@field ahead? number subgoals are so far ahead on the way [m]; 0.7 when left out
---@field arrive? number a place is reached within this [m]; 0.2 when left out
---@field check? number after so much way it is checked whether what is driven to is still worth it [m]; 0.35 when left out
---@field patience? number a way on which the robot comes no nearer for so long is blocked [s]; 8 when left out
---@field second_looks? integer so often in a run it looks again before the goal is given up; 200 when left out
---@field on_indicator? fun(indicator: indicator): ...any function(indicator), called when one was placed: {serial, x, y, run}
---@field on_decision? fun(decision: any): ...any function(decision), called after each step

---A robot's explorer: makes a map of what its sonars tell, reads indicators and ports off it, and drives to its goal. What is known stays known from run to run.
---
---Fails on no goal; a number out of range.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} }
---s = meander.sim.new { world = w }
---s:drive { navigator = 'polar', guide = e:guide() }
---print(e.ending, e.reason)
---```
---@param options meander.indicator.sonar_explorer.options where to, by which rules, on which robot
---@return sonar_explorer # the explorer, whose guide any navigator follows
function meander.indicator.sonar_explorer(options) end

---Reads a sonar explorer that sonar_explorer:save wrote: its next runs are as if nothing had been.
---
---Fails on the file cannot be read, or is none.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} }
---s = meander.sim.new { world = w }
---s:drive { navigator = 'polar', guide = e:guide() }
---f = os.tmpname()
---e:save(f)
---print(meander.indicator.open_sonar_explorer(f))
---```
---@param path string the file
---@param options? meander.indicator.open_explorer.options functions that it calls, for they are not in the file
---@return sonar_explorer # the explorer, before its next run
function meander.indicator.open_sonar_explorer(path, options) end

---The guide that it is, for sim:drive. Each drive is a run.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---print(e:guide())
---```
---@return guide # the guide
function sonar_explorer:guide() end

---Writes what it knows, map and graph, with its goal and options, for open_sonar_explorer.
---
---Fails on the file cannot be written.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} }
---s = meander.sim.new { world = w }
---s:drive { navigator = 'polar', guide = e:guide() }
---e:save(os.tmpname())
---```
---@param path string the file
function sonar_explorer:save(path) end

---A copy of its graph as it is now.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} }
---s = meander.sim.new { world = w }
---s:drive { navigator = 'polar', guide = e:guide() }
---show(e:graph():over(w))
---```
---@return indicator_graph # the graph
function sonar_explorer:graph() end

---Length of the known route from the start of the last run to the goal.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} }
---s = meander.sim.new { world = w }
---s:drive { navigator = 'polar', guide = e:guide() }
---print(e:route())
---```
---@return number|nil # length [m]; nil: none is known
function sonar_explorer:route() end

---What its map knows of a point.
---
---```lua
---e = meander.indicator.sonar_explorer { goal = {4, 0} }
---w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} }
---s = meander.sim.new { world = w }
---s:drive { navigator = 'polar', guide = e:guide() }
---print(e:known {1, 0})
---```
---@param at meander.point the point [m]
---@return string # 'free', 'wall' or 'unknown'
function sonar_explorer:known(at) end

---@alias meander.indicator.shortest_path.options.method 'network'|'dijkstra'|'hopfield'

---@class meander.indicator.shortest_path.options.hopfield
---@field row? number inhibition between the neurons of a row; 2.53 when left out
---@field column? number inhibition between the neurons of a column; 0.83 when left out
---@field bias? number excitation of every neuron; 3.89 when left out
---@field length? number weight of the lengths; 0.41 when left out
---@field missing? number what a missing link costs, in longest links; 2.45 when left out
---@field gain? number of a neuron's response; 4.36 when left out
---@field step? number of the relaxation, in time constants; 0.05 when left out
---@field steps? integer of each layer's relaxation; 400 when left out
---@field seed? integer of the small numbers that the neurons begin with; 1 when left out

---@class meander.indicator.shortest_path.options
---@field links ({ a?: number, b?: number, length?: number, [integer]: number })[] between indicators 1, 2, ...: two ends and the length of each [m]
---@field start integer an indicator
---@field goal integer an indicator
---@field method? meander.indicator.shortest_path.options.method the paper's network, its oracle, or the relaxation that does not do; 'network' when left out
---@field rows? meander.rows_name of the network: as many as the paper says, or as many as it takes; 'adaptive' when left out
---@field hopfield? meander.indicator.shortest_path.options.hopfield weights of the relaxation

---The shortest route over linked indicators by the neural network, with all that fired in it.
---
---Fails on a length that is not above 0; an end that is no whole number from 1 on.
---
---```lua
---r = meander.indicator.shortest_path { links = { {1, 2, 3}, {2, 3, 1}, {1, 3, 5} }, start = 1, goal = 3 }
---print(r.length, #r.route)
---```
---@param options meander.indicator.shortest_path.options the links, from where to where, by what
---@return table # route, length, truncated, paper_rows, rows, candidates
function meander.indicator.shortest_path(options) end

---@alias meander.world.labyrinth.options.kind 'backtracker'|'prim'|'mixed'

---@class meander.world.labyrinth.options
---@field seed? integer the same seed, the same labyrinth; 1 when left out
---@field kind? meander.world.labyrinth.options.kind long corridors, many crossings, or both; 'mixed' when left out
---@field columns? integer cells along x; 10 when left out
---@field rows? integer cells along y; 10 when left out
---@field loops? number each inner wall of the tree is taken away with this probability; 0 when left out
---@field rooms? integer so many times the inner walls of 2 to 4 by 2 to 4 cells are taken away; 0 when left out
---@field size? integer columns and rows at once, 1 to 200
---@field corridor? number side of a cell, width of the corridors between thin walls [m]; 1 when left out
---@field jitter? number corners of inner walls are moved along x and y by up to so many corridor widths; 0 when left out

---Makes the world of a labyrinth from a seed: corridors between thin walls, or crooked ones.
---
---Fails on a number out of range.
---
---```lua
---w = meander.world.labyrinth { kind = 'prim', size = 8, loops = 0.1, corridor = 1.2 }
---show(w)
---```
---@param options? meander.world.labyrinth.options the labyrinth and its walls
---@return world # the world, with a start in the first cell and the place 'goal' in the last
function meander.world.labyrinth(options) end

---@class meander.indicator.labyrinth.options
---@field seed? integer the same seed, the same labyrinth; 1 when left out
---@field kind? meander.world.labyrinth.options.kind long corridors, many crossings, or both; 'mixed' when left out
---@field columns? integer cells along x; 10 when left out
---@field rows? integer cells along y; 10 when left out
---@field loops? number each inner wall of the tree is taken away with this probability; 0 when left out
---@field rooms? integer so many times the inner walls of 2 to 4 by 2 to 4 cells are taken away; 0 when left out
---@field size? integer columns and rows at once, 1 to 200

---The cells of a labyrinth, on which rules can be tried without sensors and driving.
---
---Fails on a number out of range.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---print(l:explore(meander.indicator.explorer { goal = l.goal }).length, l:shortest())
---```
---@param options? meander.indicator.labyrinth.options kind, size, loops, rooms, seed
---@return labyrinth # the labyrinth
function meander.indicator.labyrinth(options) end

---A run of an explorer by a robot that recognises every crossing, follows corridors by itself and knows where it is.
---
---Fails on a start outside.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---print(l:explore(meander.indicator.explorer { goal = l.goal }).reason)
---```
---@param explorer explorer who decides
---@param start? meander.point a point in the cell; the first one when left out [m]
---@return table # ending, reason, length, decisions, coverage, last
function labyrinth:explore(explorer, start) end

---What explorers are compared with that keeps a map of cells: always the shortest way as if all were open that was not seen closed, kept up by D* Lite.
---
---Fails on a point outside.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---print(l:planner():walk(l).length, l:shortest())
---```
---@param to? meander.point a point in a cell, the goal; the last one when left out [m]
---@return cell_planner # the planner, which knows nothing yet
function labyrinth:planner(to) end

---Length of the shortest way.
---
---Fails on a point outside.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---print(l:shortest())
---```
---@param from? meander.point a point in a cell; the first one when left out [m]
---@param to? meander.point a point in a cell; the last one when left out [m]
---@return number|nil # length [m]; nil: there is no way
function labyrinth:shortest(from, to) end

---@alias meander.side_name 'east'|'north'|'west'|'south'

---Is there a way out of a cell on a side?
---
---Fails on no such cell.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---print(l:open(1, 1, 'east'))
---```
---@param column integer of the cell, 1 first
---@param row integer of the cell, 1 first
---@param side meander.side_name which
---@return boolean # boolean
function labyrinth:open(column, row, side) end

---Takes a wall between two cells away, or puts it there.
---
---Fails on no such cell; a wall around the labyrinth.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---l:set_open(1, 1, 'east', true)
---```
---@param column integer of the cell, 1 first
---@param row integer of the cell, 1 first
---@param side meander.side_name which
---@param open boolean true: no wall
function labyrinth:set_open(column, row, side, open) end

---@class labyrinth.world.options
---@field corridor? number side of a cell, width of the corridors between thin walls [m]; 1 when left out
---@field jitter? number corners of inner walls are moved along x and y by up to so many corridor widths; 0 when left out
---@field seed? integer of the jitter; 1 when left out

---The world with its walls.
---
---Fails on a number out of range.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---show(l:world { corridor = 1.2 })
---```
---@param options? labyrinth.world.options width of the corridors, jitter
---@return world # the world
function labyrinth:world(options) end

---A run by a robot that sees which sides of its cell are open and how far, and knows where it is.
---
---Fails on another size; a start outside.
---
---```lua
---l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 }
---p = l:planner()
---p:walk(l)
---print(p:walk(l).length)
---```
---@param labyrinth labyrinth one of the size that it was made for
---@param start? meander.point a point in the cell; the first one when left out [m]
---@return table # ending, reason, length, decisions, coverage, last
function cell_planner:walk(labyrinth, start) end

---Qualitative topologic maps: places and links from whiskers and light.
meander.topology = {}

---@class meander.topology.map.options.scales
---@field position? number places so far apart are clearly different [m]; 0.35 when left out
---@field light? number light rings so different (root mean square) are clearly different; 0.15 when left out
---@field touch? number touch rings so different (root mean square) are clearly different; 0.3 when left out

---@class meander.topology.map.options.net
---@field insert_distance? number a situation farther than this from every cell becomes a cell; 1 when left out
---@field accept_distance? number border between hit and miss; 0.8 when left out
---@field adapt? number share by which the winner moves after a miss; 0.02 when left out
---@field adapt_neighbours? number share by which its neighbours move after a miss; 0.002 when left out
---@field settle? number every hit multiplies the winner's share by this; 0.9 when left out
---@field fade? number what the winner's other links lose together; 0.05 when left out
---@field misses_to_insert? integer a cell is put at the worst place after so many misses; 0: never; 200 when left out
---@field least_component? integer pieces of the graph with fewer cells are dropped; 3 when left out

---@class meander.topology.map.options.correlation
---@field reach? number cells within this of the believed place are compared [m]; 1.5 when left out
---@field age? integer samples that a cell must be old; 60 when left out
---@field accept? number largest distance of the best cell that counts; 0.8 when left out
---@field turn_step? number headings are tried at multiples of this [rad]; 0.0523599 when left out
---@field turns? integer headings tried to each side; 0: the heading is not corrected; 5 when left out
---@field turn_cost? number cost of a tried heading, times the square of its number; 0.02 when left out
---@field gain? number share of the way to the best cell that is corrected; 0: no correction; 0.05 when left out
---@field turn_gain? number share of the best turn that is corrected; 0.02 when left out
---@field dead_zone? number nearer cells do not correct the position [m]; 0.1 when left out

---@class meander.topology.map.options.doubt
---@field suspend? number contacts against a link that suspend it; 0: links are never suspended; 2 when left out
---@field relief? number what a sample that feels the way free takes away; 0.5 when left out
---@field reach? number links of cells this near to the robot are judged [m]; 0.75 when left out
---@field surprise? number contacts that a cell expects more than this are no surprise; 0.4 when left out
---@field clear? number both cells must be this far from the line of the wall [m]; 0.05 when left out
---@field age? integer samples before anything is judged; 60 when left out

---@class meander.topology.map.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot whose whiskers and light sensors are read
---@field whisker_reach? number length of its whiskers [m]; 0.15 when left out
---@field scales? meander.topology.map.options.scales one unit of distance between situations
---@field net? meander.topology.map.options.net how the net grows and adapts
---@field correlation? meander.topology.map.options.correlation how the map corrects the believed pose
---@field doubt? meander.topology.map.options.doubt how contacts suspend links
---@field touch_smoothing? number standard deviation of the smoothing of contacts along the ring [rad]; 0.349066 when left out
---@field presentations? integer how often a situation is shown to the net; 4 when left out
---@field delay? integer samples until a situation is shown; 10 when left out

---A new, empty topologic map.
---
---Fails on a robot without whiskers, or whose rings do not begin ahead; a number out of range.
---
---```lua
---print(meander.topology.map { net = { insert_distance = 1.2 } })
---```
---@param options? meander.topology.map.options the robot, and how the map learns
---@return topologic_map # the map
function meander.topology.map(options) end

---Reads a map that map:save wrote; it goes on exactly as the other would.
---
---Fails on the file cannot be read, or is none.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---f = os.tmpname()
---m:save(f)
---print(meander.topology.open(f))
---```
---@param path string the file
---@return topologic_map # the map
function meander.topology.open(path) end

---Takes in one sample and learns.
---
---Fails on other numbers of whiskers or light sensors.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---m:step(s.observation)
---print(m.samples)
---```
---@param observation observation what the robot senses
function topologic_map:step(observation) end

---Takes in one sample without learning: the robot only stays localised, and links are judged.
---
---Fails on other numbers of whiskers or light sensors.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---m:follow(s.observation)
---print(m.pose)
---```
---@param observation observation what the robot senses
function topologic_map:follow(observation) end

---A new run begins, of another simulation or another day: no link to the last place, and odometry that begins anew.
---
---Fails on a number beyond 1e6.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---m:begin {2, 1, 0}
---print(m.pose, m.winner)
---```
---@param pose? meander.pose where the robot is now, in the frame of the map; where it was last [m, rad]
function topologic_map:begin(pose) end

---Moves where the robot believes to be. What comes next is not linked to what was.
---
---Fails on a number beyond 1e6.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---m:shift {0.1, 0}
---print(m.pose)
---```
---@param by meander.point how far [m]
function topologic_map:shift(by) end

---Suspends a link, or brings it back.
---
---Fails on no such place or link.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---l = m.links[1]
---m:suspend(l.a, l.b)
---print(m.links[1].suspended)
---```
---@param a integer number of a place
---@param b integer number of a place linked to it
---@param suspended? boolean false brings it back
function topologic_map:suspend(a, b, suspended) end

---An independent copy.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---c = m:copy()
---print(#c == #m)
---```
---@return topologic_map # the copy
function topologic_map:copy() end

---Writes it: .dot and .graphml for other programs, else for meander.topology.open.
---
---Fails on the file cannot be written.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---m:save(os.tmpname() .. '.graphml')
---```
---@param path string the file
function topologic_map:save(path) end

---The place nearest to a position.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---print(m:nearest {1, 1})
---```
---@param position meander.point in the frame of the map [m]
---@return integer|nil # its number, or nil in an empty map
function topologic_map:nearest(position) end

---The place whose senses are most like those of now, wherever it is.
---
---Fails on a map without samples.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---print(m:alike())
---```
---@return integer|nil # its number, or nil in an empty map
function topologic_map:alike() end

---@class topologic_map.way.options
---@field per_link? number cost of a link beside its length [m]; 0.03 when left out
---@field suspended? number additional cost of a suspended link [m]; 20 when left out
---@field doubtful? number additional cost of links of little confidence: this times (1 - weight), in lengths; 0 when left out

---The cheapest way over the links from one place to another.
---
---Fails on no such place.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---print(#m:way(m.winner, m.links[1].a))
---```
---@param from integer number of a place
---@param to integer the same
---@param options? topologic_map.way.options what links cost
---@return (integer|nil)[] # numbers of the places on the way, or nil when there is none
function topologic_map:way(from, to, options) end

---The picture of a world with the map over it.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---show(m:over(s.world))
---```
---@param world world in whose frame the map began
---@return picture # the picture, for show and save
function topologic_map:over(world) end

---@class meander.topology.whiskers.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field half_width? number contacts so near to the way block it [rad]; 0.785398 when left out
---@field most_detour? number slides up to this far from the wanted way [rad]; 1.8326 when left out
---@field progress? number trapped when it comes no nearer by this [m]; 0.1 when left out
---@field patience? number for so long [s]; 12 when left out

---A navigator for omnidirectional robots: straight on, and along what the whiskers touch.
---
---Fails on a robot without whiskers or whose first is not ahead; one that cannot go sideways.
---
---```lua
---print(meander.topology.whiskers {}.name)
---```
---@param options? meander.topology.whiskers.options the robot, and when it slides or gives up
---@return navigator # the navigator
function meander.topology.whiskers(options) end

---@class meander.topology.wander.options.revisit
---@field share? number of the behaviours that drive to doubted links, while there are any; 0 when left out
---@field tries? integer of a link that cannot be driven, before it is left alone; 3 when left out
---@field pause? integer samples between two tries of a link; 500 when left out
---@field patience? integer samples without progress until it is held up; 20 when left out
---@field beside? number links this near to a blocked one, in its direction, are doubted too [m]; 0.6 when left out

---@class meander.topology.wander.options
---@field map topologic_map the map that it fills
---@field samples? integer to gather before it ends; 5000 when left out
---@field seed? integer of its random choices; 1 when left out
---@field shortest? integer samples that a behaviour lasts at least; 60 when left out
---@field longest? integer samples that a behaviour lasts at most; 260 when left out
---@field half_width? number contacts so near to the way block it [rad]; 0.785398 when left out
---@field wall_turn? number turn per sample towards a wall that was lost [rad]; 0.261799 when left out
---@field lookahead? number how far ahead it counts cells of the map [m]; 1 when left out
---@field crowd? number radius of the area in which it counts them [m]; 0.7 when left out
---@field revisit? meander.topology.wander.options.revisit how it drives to doubted links

---A guide that explores: bouncing off, along walls, to where the map has few places. Fills the map. With revisit.share it also drives to links that contacts speak against, and tries to pass them.
---
---Fails on no map; a number out of range.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 100, revisit = { share = 0.5 } } }
---print(m)
---```
---@param options meander.topology.wander.options the map, how many samples, the seed of its choices, how doubted links are revisited
---@return guide # the guide
function meander.topology.wander(options) end

---@class meander.topology.route.options
---@field map topologic_map the map whose links are driven
---@field to integer number of the place to go to
---@field route? topologic_map.way.options what links cost
---@field near? number a place on the way counts as passed within this [m]; 0.25 when left out
---@field arrive? number the goal is reached within this [m]; 0.12 when left out
---@field confirm? number a place this near to the goal is as good when the senses are like the goal's [m]; 0.2 when left out
---@field like? number largest distance of senses that are like the goal's; 0.8 when left out
---@field pull? number share of the way to the place that the senses tell when that is another; 0.4 when left out
---@field tries? integer points around the goal where it looks; 40 when left out
---@field progress? number stuck when the wheels do not bring it this far [m]; 0.3 when left out
---@field patience? integer in so many samples; 60 when left out
---@field most_samples? integer for the whole way; 3000 when left out
---@field recoveries? integer how often a lost robot looks for itself in the whole map; 5 when left out
---@field learn? boolean go on learning while driving; false when left out

---A guide over the links of a map to one of its places. It believes to be there only when the senses agree.
---
---Fails on no map; no such place; a number out of range.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---print(s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.route { map = m, to = m.links[1].a } }.success)
---```
---@param options meander.topology.route.options the map, the place, and how it drives
---@return guide # the guide
function meander.topology.route(options) end

---@class meander.topology.minimal.options
---@field map topologic_map the map that localises the robot, whose options it takes
---@field adapt? number share of the map's rates at which the light and touch nets adapt; 0.5 when left out
---@field fade? number what the winner's other links lose together in the light and touch nets; 0.02 when left out
---@field stable_place? number a place is known within this many accepted distances; 2 when left out
---@field stable_senses? number light and touch are known within this many accepted distances; 0.5 when left out
---@field light_scale? number light rings so different (root mean square) are clearly different; 0.2 when left out
---@field jitter? number a border is not put this near to one that says the same [m]; 0.3 when left out

---The minimal model beside a topologic map: three nets that share lights and touches.
---
---Fails on no map; a number out of range.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---k = meander.topology.minimal { map = m }
---k:step(m)
---print(k)
---```
---@param options meander.topology.minimal.options the map that localises it, and how the nets differ from its
---@return minimal_map # the minimal map
function meander.topology.minimal(options) end

---Takes in the situation that the map has now.
---
---Fails on a map of another robot, or one without samples.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---k = meander.topology.minimal { map = m }
---k:step(m)
---k:step(m)
---```
---@param map topologic_map the map that localises it
function minimal_map:step(map) end

---How large the nets are, and how many bytes they take.
---
---Fails on a map of another robot; more than 254 lights or touches.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---k = meander.topology.minimal { map = m }
---k:step(m)
---print(k:sizes(m).bytes)
---```
---@param map topologic_map the whole map to compare with
---@return table # {geometry, light, touch, bytes, bytes_of_map, bytes_quantised}
function minimal_map:sizes(map) end

---Where the model takes the map's situation of now to be.
---
---Fails on a map of another robot, or one without samples; more than 254 lights or touches, when quantised.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---k = meander.topology.minimal { map = m }
---k:step(m)
---print(k:recognise(m, true).x)
---```
---@param map topologic_map the map that localises it
---@param quantised? boolean with one byte a value
---@param senses_alone? boolean by touch and light, wherever the robot believes to be
---@return meander.point|nil # the position of that place, or nil in an empty model
function minimal_map:recognise(map, quantised, senses_alone) end

---Writes the model with one byte a value as a C header, for micro-controllers.
---
---Fails on more than 254 lights or touches; a name that is no C identifier.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' }
---m = meander.topology.map {}
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 200 } }
---k = meander.topology.minimal { map = m }
---k:step(m)
---k:save_c(os.tmpname())
---```
---@param path string the file
---@param name? string what its arrays begin with
function minimal_map:save_c(path, name) end

---@class meander.study.place_scores.options
---@field age? integer younger places are no recognition, in samples; 100 when left out
---@field within? number a place is right when its true place is this near and in sight [m]; 0.5 when left out
---@field bin? number side of the squares that count as visited again [m]; 0.15 when left out
---@field hits? integer the true place of a cell is the mean over about its last so many hits; 60 when left out

---Scores how well a topologic map knows places. Begin it before the first cycle.
---
---Fails on a number out of range.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice' }
---m = meander.topology.map {}
---p = meander.study.place_scores(s)
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 300 }, on_step = function() p:add(m) end }
---print(p:summary().recall)
---```
---@param sim sim the simulation whose truth counts
---@param options? meander.study.place_scores.options what counts as right
---@return place_scores # the scores
function meander.study.place_scores(sim, options) end

---A cycle has ended; call it from on_step.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice' }
---m = meander.topology.map {}
---p = meander.study.place_scores(s)
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 300 }, on_step = function() p:add(m) end }
---p:add(m)
---```
---@param map topologic_map the map that took in the observation before the cycle
function place_scores:add(map) end

---Errors of the believed position, recall and precision of places.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice' }
---m = meander.topology.map {}
---p = meander.study.place_scores(s)
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 300 }, on_step = function() p:add(m) end }
---print(p:summary().error_mean)
---```
---@return table # table
function place_scores:summary() end

---How far the places of a map lie from where they truly are: root mean square.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice' }
---m = meander.topology.map {}
---p = meander.study.place_scores(s)
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 300 }, on_step = function() p:add(m) end }
---print(p:map_error(m))
---```
---@param map topologic_map the map
---@return number # the error in metres; 0 when no place ever won
function place_scores:map_error(map) end

---Where the robot truly was on average when a place won.
---
---Fails on no such place.
---
---```lua
---s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice' }
---m = meander.topology.map {}
---p = meander.study.place_scores(s)
---s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = 300 }, on_step = function() p:add(m) end }
---print(p:true_place(m, m.winner).x)
---```
---@param map topologic_map the map
---@param number integer of the place
---@return meander.point|nil # the position, or nil when it never won
function place_scores:true_place(map, number) end

---What a value is: 'world', 'sim', 'run', ... for objects of meander, otherwise what type() says.
---
---```lua
---print(meander.kind(meander.world.new {}), meander.kind {})
---```
---@param value any anything
---@return string # the word
function meander.kind(value) end

---For messages of scripts: the nearest of several names to one that was misspelt.
---
---```lua
---print(meander.did_you_mean('sede', { 'seed', 'time' }))
---```
---@param name string what was written
---@param names string[] what could have been meant
---@return string # "; did you mean 'x'?", or an empty text where none is near
function meander.did_you_mean(name, names) end

---Radians from degrees: heading = deg(30). Angles are in radians everywhere; Lua's math.rad is the same.
---
---```lua
---print(deg(180))
---```
---@param angle number in degrees
---@return number # the angle in radians
function deg(angle) end

---Degrees from radians: rad(math.pi) is 180. For printing angles; Lua's math.deg is the same.
---
---```lua
---print(rad(math.pi))
---```
---@param angle number in radians [rad]
---@return number # the angle in degrees
function rad(angle) end

---Draws in the terminal: a world, a sim, a run, a sonar reading, a picture; numbers as a curve, a matrix or a list of rows as a heat map.
---
---Fails on something that has no picture.
---
---```lua
---show(meander.world.open 'worlds/office.toml')
---```
---@param object any what to draw
function show(object) end

---Says what something is and how it is used.
---
---Fails on nothing is known about it.
---
---```lua
---help 'sim:drive'
---```
---@param what? any a function, module or object of meander, or a name; everything when left out
function help(what) end

---Lists everything whose name, description or options contain a word.
---
---```lua
---apropos 'sonar'
---```
---@param word string what to look for
function apropos(word) end

