// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/kit_doc.hpp"

namespace meander::script {

/// A property beside the methods in a type's member table, as raw userdata: found by one table access.
struct Property {
  const Record* record;
  int (*get)(lua_State*, const Record&);
  int (*set)(lua_State*, const Record&);  ///< nullptr: read only
};

/// The record of the type of the object at `index`, or nullptr when that is no object of the bindings.
const Record* type_record(lua_State* L, int index);

/// The shared part of all types, by tag.
class TypeBuilder {
 public:
  TypeBuilder(lua_State* L, const TypeTag& tag, const char* text);
  /// Adds to a type that exists.
  TypeBuilder(lua_State* L, const TypeTag& tag) : L_(L), tag_(tag) {}

 protected:
  void add_method(Record record, lua_CFunction function);
  void add_property(Record record, int (*get)(lua_State*, const Record&), int (*set)(lua_State*, const Record&));
  /// A function for an event of the metatable; its record only gives messages their name.
  void add_event(const char* event, const char* shown_as, lua_CFunction function);
  /// `get` finds self and an integer key on the stack.
  void add_element(std::string type, int (*get)(lua_State*, const Record&));

  lua_State* L_;
  const TypeTag& tag_;
};

/// Describes a type to Lua: methods, properties, and what print, #, ==, [i] do.
template <Object T>
class Type : public TypeBuilder {
 public:
  Type(lua_State* L, const char* text) : TypeBuilder(L, tag_of<T>, text) {}
  explicit Type(lua_State* L) : TypeBuilder(L, tag_of<T>) {}

  template <auto F>
  Type& method(CompleteDoc<arity<F> - 1, returns_something<F>> doc) {
    add_method(make_record<F, true>(doc.doc, tag_.name), entry<F, true>);
    return *this;
  }

  template <auto Get>
  Type& property(CompletePropertyDoc doc) {
    add_property(property_record<Get>(doc.doc), getter<Get>, nullptr);
    return *this;
  }
  template <auto Get, auto Set>
  Type& property(CompletePropertyDoc doc) {
    Record record = property_record<Get>(doc.doc);
    record.settable = true;
    add_property(std::move(record), getter<Get>, setter<Set>);
    return *this;
  }

  /// std::string F(const T&): what print shows.
  template <auto F>
  Type& text() {
    add_event("__tostring", "tostring", loose<F>);
    return *this;
  }
  template <auto F>
  Type& length() {
    add_event("__len", "length", loose<F>);
    return *this;
  }
  /// bool F(const T&, const T&)
  template <auto F>
  Type& equal() {
    add_event("__eq", "equality", equality<F>);
    return *this;
  }
  /// F(const T&, lua_Integer): what [i] gives; an empty optional ends ipairs().
  template <auto F>
  Type& element() {
    add_element(ResultType<std::remove_cvref_t<typename SignatureOf<F>::Result>>::text(), at<F>);
    return *this;
  }
  /// DrawList F(const T&): what show(), save and text of meander.render draw.
  template <auto F>
  Type& picture() {
    add_event("__show", "show", loose<F>);
    return *this;
  }

 private:
  template <auto Get>
  Record property_record(const PropertyDoc& doc) const {
    using R = std::remove_cvref_t<typename SignatureOf<Get>::Result>;
    Record record{.kind = DocKind::property, .owner = tag_.name, .member = doc.name, .text = doc.text};
    record.returns_type = ResultType<R>::text();
    record.returns = doc.unit;
    record.example = doc.example;
    return record;
  }
  template <auto Get>
  static int getter(lua_State* L, const Record& record) {
    return border(L, record, [&] {
      const auto self = read_object<T>(L, 1, Path{.kind = Path::Kind::self});
      using Self = std::remove_cvref_t<std::tuple_element_t<0, typename SignatureOf<Get>::Arguments>>;
      if constexpr (std::is_same_v<Self, std::shared_ptr<T>>)
        return push_result(L, Get(self));  // a view, which keeps its owner alive
      else
        return push_result(L, std::invoke(Get, *self));
    });
  }
  template <auto F>
  static int at(lua_State* L, const Record& record) {
    return border(L, record, [&] {
      const auto self = read_object<T>(L, 1, Path{.kind = Path::Kind::self});
      return push_result(L, std::invoke(F, *self, lua_tointeger(L, 2)));
    });
  }
  /// The stack is that of __newindex: self, key, value.
  template <auto Set>
  static int setter(lua_State* L, const Record& record) {
    return border(L, record, [&] {
      using Reader = detail::Parameter<std::tuple_element_t<1, typename SignatureOf<Set>::Arguments>>;
      const auto self = read_object<T>(L, 1, Path{.kind = Path::Kind::self});
      auto value = Reader::read(L, 3, Path{.kind = Path::Kind::value, .name = "value"});
      std::invoke(Set, *self, Reader::pass(value));
      return 0;
    });
  }
  /// Events are called by Lua with more arguments than they take; closed objects may be printed.
  template <auto F>
  static int loose(lua_State* L) {
    const auto& record = *static_cast<const Record*>(lua_touserdata(L, lua_upvalueindex(1)));
    return border(L, record, [&] {
      lua_settop(L, 1);
      const ObjectBox* box = test_box(L, 1, tag_of<T>);
      if (box && !box->object) return push_result(L, std::string("closed ") + ObjectName<T>::value);
      return invoke<F, true>(L, record);
    });
  }
  /// Things of different types, or closed ones, are simply not equal.
  template <auto F>
  static int equality(lua_State* L) {
    const auto& record = *static_cast<const Record*>(lua_touserdata(L, lua_upvalueindex(1)));
    return border(L, record, [&] {
      const ObjectBox* a = test_box(L, 1, tag_of<T>);
      const ObjectBox* b = test_box(L, 2, tag_of<T>);
      const bool comparable = a && b && a->object && b->object;
      return push_result(L, comparable && std::invoke(F, *static_cast<const T*>(a->object.get()),
                                                      *static_cast<const T*>(b->object.get())));
    });
  }
};

}  // namespace meander::script
