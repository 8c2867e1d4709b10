// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <concepts>
#include <memory>

#include "script/kit_value.hpp"

namespace meander::script {

/// Marks a C++ type that scripts hold by reference: specialise with `static constexpr const char* value = "world";`.
template <class T>
struct ObjectName;

template <class T>
concept Object = requires {
  ObjectName<T>::value;
};

/// The address of a type's tag tells boxes apart.
struct TypeTag {
  const char* name;
};
template <Object T>
inline const TypeTag tag_of{ObjectName<T>::value};

/// Userdata that shares ownership of a native object. `object` is empty once the userdata was closed (<close>) or
/// collected; it then answers "the ... is closed".
struct ObjectBox {
  const TypeTag* tag;
  std::shared_ptr<void> object;
};

/// Bytes that the object keeps alive outside Lua's view; overload for types that own much.
template <class T>
std::size_t native_size(const T&) {
  return sizeof(T);
}

/// The box at `index` if it is one of the given type, or nullptr. Open or closed.
ObjectBox* test_box(lua_State* L, int index, const TypeTag& tag);
/// Pushes a new userdata for the object.
void push_new(lua_State* L, const TypeTag& tag, std::shared_ptr<void> object);
/// The same object pushed twice gives the same userdata, so that == and table keys work. True when it is a new one.
bool push_shared(lua_State* L, const TypeTag& tag, std::shared_ptr<void> object);
/// Tells Lua's collector about native memory that hangs on the userdata just pushed.
void account(lua_State* L, std::size_t bytes);
/// Pushes the metatable of a type, made empty at its first use.
void push_metatable(lua_State* L, const TypeTag& tag);

/// The object at `index`; ownership is shared while the result lives, so that nothing a callback does can end it.
template <Object T>
std::shared_ptr<T> read_object(lua_State* L, int index, const Path& path) {
  const ObjectBox* box = test_box(L, index, tag_of<T>);
  if (!box) expected(L, index, path, ObjectName<T>::value);
  if (!box->object) fail("{}: the {} is closed", path.text(), ObjectName<T>::value);
  return std::static_pointer_cast<T>(box->object);
}

/// Things that can be met again (a world that a simulation returns) cross as shared_ptr and keep their identity.
template <Object T>
struct Lua<std::shared_ptr<T>> {
  static std::shared_ptr<T> read(lua_State* L, int index, const Path& path) { return read_object<T>(L, index, path); }
  static void push(lua_State* L, const std::shared_ptr<T>& object) {
    if (!object)
      lua_pushnil(L);
    else if (push_shared(L, tag_of<T>, object))
      account(L, native_size(*object));
  }
  static std::string type() { return ObjectName<T>::value; }
};

/// Results that nobody else holds cross by value.
template <Object T>
struct Lua<T> {
  static T read(lua_State* L, int index, const Path& path) { return *read_object<T>(L, index, path); }
  static void push(lua_State* L, T value) {
    const std::size_t bytes = native_size(value);
    push_new(L, tag_of<T>, std::make_shared<T>(std::move(value)));
    account(L, bytes);
  }
  static std::string type() { return ObjectName<T>::value; }
};

}  // namespace meander::script
