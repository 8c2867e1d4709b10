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

---All that the robot side gets to see in a control cycle: sonar, bumpers, odometry.
---@class observation
---@field time number Time since the start. [s]
---@field period number Length of the cycle that ends here. [s]
---@field pose meander.pose Where the odometry says it is. [m, rad]
---@field v number Forward speed. [m/s]
---@field w number Turning rate. [rad/s]
---@field sonar numbers Ranges in ring order, the first forward, counter-clockwise; the largest range: no echo. [m]
---@field sonar_poses meander.pose[] Odometry pose of the robot at which each range was taken. [m, rad]
---@field bumper numbers Bumpers in ring order; 1: pressed.
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
---@field resolution? number size of a pixel (pictures) [m/pixel]; 0.05 when left out
---@field threshold? number grey from which on a pixel is light (pictures); 0: chosen by Otsu's method; 0 when left out
---@field negate? boolean walls are light on dark (pictures); false when left out
---@field unknown? meander.unknown_name what unknown cells are (ROS maps): solid and a warning where doubtful, free, or solid; 'auto' when left out
---@field convention? meander.convention_name whose comparisons count at the thresholds (ROS maps); 'nav2' when left out
---@field index? integer which of the worlds (BARN tables); 0 when left out
---@field epsilon? number how far a straight outline may leave the edges of cells (maps and pictures) [cells]; 0.49 when left out
---@field min_area? number smaller solid patches are dropped as specks (maps and pictures) [m^2]; 0 when left out

---Reads other people's maps by suffix: world files, ROS maps (.yaml), pictures of floor plans (.png, .pgm, .jpg), BARN tables (.csv).
---
---Fails on no such file; unknown suffix; what is wrong in it.
---
---```lua
---w, report = meander.world.import('worlds/office.toml')
---```
---@param path string a .toml, .yaml, .yml, .png, .pgm, .jpg, .jpeg, .bmp, .tif, .tiff or .csv file
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

---@alias meander.robot_name 'nomad200'|'scout'

---@class meander.polar.potential_field.options.robot.body
---@field radius? number radius of the round body [m]; 0.2667 when left out
---@field v_max? number largest forward speed [m/s]; 0.6096 when left out
---@field v_min? number least speed; 0: no reversing [m/s]; 0 when left out
---@field w_max? number largest turning rate [rad/s]; 0.785398 when left out
---@field a_v? number largest acceleration and braking [m/s^2]; 0.762 when left out
---@field a_w? number largest turning acceleration [rad/s^2]; 1.0472 when left out

---@class meander.polar.potential_field.options.robot.sonar
---@field count? integer number of transducers; 16 when left out
---@field radius? number radius of the circle that the transducers sit on [m]; 0.23 when left out
---@field first? number bearing of the first transducer [rad]; 0 when left out

---@class meander.polar.potential_field.options.robot.bumper
---@field count? integer number of transducers; 20 when left out
---@field radius? number radius of the circle that the transducers sit on [m]; 0.2667 when left out
---@field first? number bearing of the first transducer [rad]; 0 when left out

---@class meander.polar.potential_field.options.robot
---@field preset? meander.robot_name the named set that the other keys change
---@field name? string name of the platform
---@field body? meander.polar.potential_field.options.robot.body size and limits of the body
---@field sonar? meander.polar.potential_field.options.robot.sonar places of the sonars
---@field bumper? meander.polar.potential_field.options.robot.bumper places of the bumpers
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

---@alias meander.weights_name 'finite_volume'|'euclidean'|'lattice'

---@class meander.polar.navigator.options.map
---@field rings? integer rings of units, the centre included; 100 when left out
---@field sectors? integer units on each ring; 48 when left out
---@field scope? number radius of the outermost ring [m]; 2.54 when left out
---@field radii? meander.radii_name equally spaced, or growing by a constant factor; 'uniform' when left out
---@field innermost? number radius of ring 1 of logarithmic radii [m]; 0.05 when left out
---@field weights? meander.weights_name weights of the connections; 'finite_volume' when left out
---@field kappa? number how fast activation decays along a way, with finite volumes [1/m]; 30 when left out
---@field margin? number units nearer to a point than the robot's radius and this are obstructed [m]; 0.05 when left out
---@field narrow_margin? number the same, when no activation reaches the robot otherwise [m]; 0.02 when left out
---@field merge? number remembered points in the same square of this size count once; 0: all count [m]; 0.03 when left out

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
---@field hysteresis? number another direction wins only if its way is so much shorter [m]; 0.5 when left out
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
---@field loop? number coming so near to where it began means that there is no way on this side [m]; 0.5 when left out

---@class meander.polar.navigator.options.trap
---@field watch? boolean notice being trapped; true when left out
---@field patience? number trapped after so long without progress [s]; 15 when left out
---@field progress? number what counts as progress towards the subgoal [m]; 0.1 when left out
---@field escapes? integer tries to get out along the wall, on one side and the other, before the guide is told; 4 when left out
---@field escape? meander.polar.navigator.options.trap.escape along the wall

---@class meander.polar.navigator.options.own
---@field weights? fun(ring: any): ...any function(ring): weights {inward =, outward =, lateral =, leak =} of a ring
---@field objective? fun(candidate: any): ...any function(candidate): its cost; the least is taken
---@field subgoal? fun(map: any): ...any function(map): ring and sector of the subgoal, or nil: no way

---@class meander.polar.navigator.options
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot that it drives
---@field mode? meander.mode_name with the remedies beyond the paper, or without them; 'full' when left out
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
---Fails on another kind of navigator.
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

---@class meander.sim.new.options.drift
---@field distance_bias? number relative error of distances; 0 when left out
---@field turn_bias? number relative error of turns; 0 when left out
---@field veer? number false turn per metre [rad/m]; 0 when left out
---@field distance_noise? number random error of distances per root metre [m/m^0.5]; 0 when left out
---@field turn_noise? number random error of turns per root radian [rad/rad^0.5]; 0 when left out
---@field veer_noise? number random false turn per root metre [rad/m^0.5]; 0 when left out

---@class meander.sim.new.options.robots
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot, by name or in detail
---@field sonar? meander.sonar_name|meander.sim.new.options.sonar model of the sonars, by name or in detail
---@field drift? meander.sim.new.options.drift errors of the odometry; none when left out
---@field start? meander.pose|string|thing where it starts; the world's start when left out [m, rad]

---@class meander.sim.new.options
---@field world world where it happens; edits take effect at the next step
---@field robot? meander.robot_name|meander.polar.potential_field.options.robot kind of robot, by name or in detail
---@field sonar? meander.sonar_name|meander.sim.new.options.sonar model of the sonars, by name or in detail
---@field drift? meander.sim.new.options.drift errors of the odometry; none when left out
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

