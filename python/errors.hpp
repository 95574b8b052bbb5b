// The module's exceptions. Each has what it is about: reason, field, byte.
#pragma once
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <string_view>

namespace python {

namespace py = pybind11;

/// Where an error is; None where it is of no field or byte.
struct error_place {
    std::string field{};
    std::optional<std::size_t> byte{};
};

/// Classes of exceptions, made once with the module. They live as long as the interpreter.
struct error_classes {
    PyObject *base{}, *decode{}, *encode{}, *unknown_message{}, *translate{}, *configuration{}, *node{}, *refused{},
        *no_answer{};

    static error_classes& all() {
        static error_classes made;
        return made;
    }
    void add_to(py::module_& module) {
        base =
            add(module, "Error", PyExc_Exception,
                "An error of this module. `reason` is what is wrong, without the place; `field` and `byte` are where,\n"
                "or None.");
        for (const char* const name : {"reason", "field", "byte"}) py::handle{base}.attr(name) = py::none{};
        decode = add(module, "DecodeError", base, "Bytes that are no message; `byte` counts from the first of them.");
        encode = add(module, "EncodeError", base, "Fields that make no message; `field` is a path: pose[1].pose_time.");
        unknown_message = add(module, "UnknownMessageError", base, "No message has this name or code.");
        translate = add(module, "TranslateError", base, "A table refuses a message or a packet.");
        configuration = add(module, "ConfigurationError", base, "A configuration, an address or a port is unusable.");
        node = add(module, "NodeError", base, "An operation of a component failed.");
        refused = add(module, "RefusedError", node, "The receiver refused the message (NAK).");
        no_answer = add(module, "NoAnswerError", node, "No answer in time; a command may have been executed.");
    }

  private:
    static PyObject* add(py::module_& module, const char* name, PyObject* of, const char* text) {
        const std::string whole = std::string{"jauscat."} + name;
        PyObject* const made = PyErr_NewExceptionWithDoc(whole.c_str(), text, of, nullptr);
        if (made == nullptr) throw py::error_already_set{};
        module.attr(name) = py::handle{made};
        return made;
    }
};

[[noreturn]] inline void raise(PyObject* type, const std::string& message, std::string_view reason,
                               const error_place& place = {}) {
    const py::object error = py::handle{type}(message);
    error.attr("reason") = py::str{reason.data(), reason.size()};
    if (!place.field.empty()) error.attr("field") = place.field;
    if (place.byte) error.attr("byte") = *place.byte;
    PyErr_SetObject(type, error.ptr());
    throw py::error_already_set{};
}
[[noreturn]] inline void raise(PyObject* type, const std::string& message) { raise(type, message, message); }

} // namespace python
