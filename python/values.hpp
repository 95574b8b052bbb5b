// Values of messages as Python's, and back.
//
// A message is a dict of its fields by name. Numbers, real ones too, are numbers; text is str, or {"hex": ...} where it
// is not UTF-8; bytes, and messages inside messages, are bytes; groups are lists; a variant is a dict of one item, its
// alternative. Counts follow from the lists. Whatever text and JSON accept is accepted.
#pragma once
#include <jauscat/catalogue/any_message.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/quoted.hpp>
#include <jauscat/text/value.hpp>

#include <cmath>
#include <pybind11/pybind11.h>
#include <string>
#include <variant>

namespace python {

namespace py = pybind11;
namespace text = jauscat::text;

inline py::str to_str(std::string_view text) { return {text.data(), text.size()}; }
inline py::bytes to_bytes(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Writes any structure; `scope` is what is around it, for the tags of choices.
class value_writer {
  public:
    py::dict fields(const text::structure& type, const void* object, bool is_outermost = true) {
        const text::scope here{type.id, object, around_};
        around_ = &here;
        py::dict made;
        for (const text::member& one : type.members) {
            if (one.what == text::member::role::presence_vector && !is_outermost)
                made[to_str(one.name)] = one.number(object);
            if (one.what != text::member::role::value) continue;
            if (const void* const found = one.find(object); found != nullptr)
                made[to_str(one.name)] = member_value(one, found);
        }
        around_ = here.outer;
        return made;
    }

  private:
    py::object member_value(const text::member& one, const void* at) {
        if (!std::holds_alternative<text::choice_form>(one.how->is)) return value(*one.how, at);
        const text::held_case held = text::case_of(one, at, around_);
        if (!held.known) return py::none{};
        return held.how == nullptr ? py::object{py::dict{}} : value(*held.how, held.at);
    }
    py::object value(const text::form& how, const void* at) {
        return std::visit([&](const auto& is) -> py::object { return told(is, at); }, how.is);
    }

    static py::object told(const text::integer_form& is, const void* at) {
        if (is.what == text::integer_form::meaning::boolean) return py::bool_{is.get(at) != 0};
        if (is.is_signed) return py::int_{static_cast<std::int64_t>(is.get(at))};
        return py::int_{is.get(at)};
    }
    static py::object told(const text::real_form& is, const void* at) { return py::float_{is.get(at)}; }
    static py::object told(const text::scaled_form& is, const void* at) { return py::float_{is.get(at)}; }
    static py::object told(const text::octets_form& is, const void* at) {
        const auto bytes = is.get(at);
        if (!is.characters) return to_bytes(bytes);
        const std::string characters{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
        if (text::is_utf8(characters)) return py::str{characters};
        py::dict made;
        made["hex"] = to_str(text::hex(bytes));
        return made;
    }
    py::object told(const text::structure_form& is, const void* at) { return fields(*is.of, at, false); }
    static py::object told(const text::packed_form& is, const void* at) { return py::int_{is.get(at)}; }
    static py::object told(const text::encoded_form& is, const void* at) { return to_bytes(is.encode(at)); }
    py::object told(const text::variant_form& is, const void* at) {
        const text::alternative& held = is.alternatives[is.index(at)];
        py::dict made;
        made[to_str(held.name)] = held.how == nullptr ? py::object{py::dict{}} : value(*held.how, is.get(at));
        return made;
    }
    py::object told(const text::list_form& is, const void* at) {
        py::list made;
        const auto* element = static_cast<const std::byte*>(is.first(at));
        for (std::size_t left = is.size(at); left != 0; --left, element += is.stride) {
            py::object one = value(*is.element, element);
            if (!is.field.empty() && (py::isinstance<py::dict>(one) || py::isinstance<py::list>(one))) {
                py::dict named;
                named[to_str(is.field)] = one;
                one = named;
            }
            made.append(one);
        }
        return made;
    }
    py::object told(const text::tree_form& is, const void* at) {
        const auto* next = static_cast<const std::byte*>(is.nodes.first(at));
        std::size_t left = is.nodes.size(at);
        return left == 0 ? py::object{py::none{}} : node(is, next, left);
    }
    py::object told(const text::choice_form&, const void*) { return py::none{}; } // always a member, see member_value

    py::object node(const text::tree_form& is, const std::byte*& next, std::size_t& left) {
        const std::byte* const here = next;
        py::object made = value(*is.nodes.element, here);
        next += is.nodes.stride;
        --left;
        py::list children;
        for (std::uint64_t more = is.children.get(here); more != 0 && left != 0; --more)
            children.append(node(is, next, left));
        made["child"] = children;
        return made;
    }

    const text::scope* around_{};
};

/// A number as text::scan takes it.
inline std::string number_text(const py::float_& number) {
    const auto real = number.cast<double>();
    if (std::isnan(real)) return "NaN";
    if (std::isinf(real)) return real > 0 ? "Infinity" : "-Infinity";
    return py::repr(number).cast<std::string>();
}

/// Values deeper than a message can be are a TypeError, so that a list which contains itself ends.
inline text::input input_of(const py::handle& value, std::size_t level = 0) {
    text::input made{.what = text::input::kind::leaf};
    if (level == text::max_levels) throw py::type_error{"the fields of a message are not nested as deep"};
    PyObject* const object = value.ptr();
    if (value.is_none()) {
        made.what = text::input::kind::nothing;
    } else if (PyBool_Check(object)) {
        made.text = object == Py_True ? "true" : "false";
    } else if (PyUnicode_Check(object)) {
        made.text = value.cast<std::string>();
    } else if (PyBytes_Check(object) || PyByteArray_Check(object)) {
        made.text = py::bytes{value.attr("hex")().cast<std::string>()}.cast<std::string>();
    } else if (py::isinstance<py::dict>(value)) {
        made.what = text::input::kind::object;
        for (const auto& [name, part] : py::reinterpret_borrow<py::dict>(value)) {
            if (!PyUnicode_Check(name.ptr())) throw py::type_error{"the names of fields are str"};
            made.parts.emplace_back(input_of(part, level + 1)).name = name.cast<std::string>();
        }
    } else if (PyFloat_Check(object)) {
        made.text = number_text(py::float_{py::reinterpret_borrow<py::object>(value)});
    } else if (PyIndex_Check(object) != 0) { // int, IntEnum, numpy's integers
        const auto number = py::reinterpret_steal<py::object>(PyNumber_ToBase(object, 10));
        if (!number) throw py::error_already_set{};
        made.text = number.cast<std::string>();
    } else if (PySequence_Check(object) != 0) {
        made.what = text::input::kind::array;
        for (const auto& part : value) made.parts.push_back(input_of(part, level + 1));
    } else if (const auto number = py::reinterpret_steal<py::object>(PyNumber_Float(object)); number) {
        made.text = number_text(py::float_{number}); // Decimal, Fraction
    } else {
        PyErr_Clear();
        throw py::type_error{"no value of a field: " + py::repr(value).cast<std::string>()};
    }
    return made;
}

} // namespace python
