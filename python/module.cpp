// The Python module: messages, tables, nodes. jauscat/__init__.pyi has the types.
#include "errors.hpp"
#include "messages.hpp"
#include "node.hpp"
#include "tables.hpp"
#include <jauscat/version.hpp>

#include <sstream>

namespace {

using namespace python;
using namespace py::literals;

std::vector<message_type> messages(const std::string& which) {
    std::vector<message_type> made;
    const auto of = generation_of(which);
    for (const auto& one : messages_of(of)) made.push_back({one, of});
    return made;
}

void add_messages(py::module_& module) {
    py::class_<field>(module, "Field", "What is known of a field of a message.")
        .def_readonly("name", &field::name)
        .def_readonly(
            "kind", &field::kind,
            "integer, enumeration, flags, boolean, real, text, bytes, record, packed, message, list, tree, choice,\n"
            "variant, or empty.")
        .def_readonly("unit", &field::unit, "Empty where it has none.")
        .def_readonly("lowest", &field::lowest, "The lowest number; None where it is no number.")
        .def_readonly("highest", &field::highest)
        .def_readonly("names", &field::names, "The names of an enumeration's values, or of flags' bits.")
        .def_readonly("optional", &field::is_optional, "Whether it may be absent.")
        .def_readonly("presence_bit", &field::presence_bit, "Its bit of the presence vector, or None.")
        .def_readonly("least", &field::least, "Elements, characters or bytes; None where it has none.")
        .def_readonly("most", &field::most)
        .def_readonly("fields", &field::fields, "Of a record, an element of a list, or the alternatives of a variant.")
        .def("__repr__", [](const field& of) { return "<jauscat.Field " + of.name + ": " + of.kind + ">"; });

    py::class_<message>(module, "Message", "A message with its values: message[\"desired_speed\"].")
        .def_property_readonly("type", [](const message& of) { return message_type{of.type, of.of}; })
        .def_property_readonly("name", [](const message& of) { return of.type.name(); })
        .def_property_readonly("code", [](const message& of) { return of.type.command_code(); })
        .def_readonly("fields", &message::fields, "The fields that are there, by name, in the order of the bytes.")
        .def_readonly("presence_vector", &message::presence_vector, "Of the whole message; None where it has none.")
        .def_readonly("body", &message::body, "The bytes of the fields; of SAE, with the message ID in front.")
        .def_readonly("source", &message::source, "The JAUS ID of its sender; empty where it is not known.")
        .def_readonly("destination", &message::destination)
        .def_readonly("sequence_number", &message::sequence_number, "None where it is not known.")
        .def_readonly("wants_acknowledgement", &message::wants_acknowledgement)
        .def(
            "__getitem__", [](const message& of, const py::str& name) { return py::object{of.fields[name]}; }, "name"_a)
        .def(
            "__contains__", [](const message& of, const py::str& name) { return of.fields.contains(name); }, "name"_a)
        .def("__str__",
             [](const message& of) {
                 auto text = std::string{of.type.name()} + "\n" + of.type.to_text(bytes_of(of.body));
                 while (text.ends_with('\n')) text.pop_back();
                 return text;
             })
        .def("__repr__", [](const message& of) {
            return "<jauscat.Message " + std::string{of.type.name()} + " " + py::repr(of.fields).cast<std::string>() +
                   ">";
        });

    py::class_<message_type>(module, "MessageType", "A message that may be sent or received, without values.")
        .def_property_readonly("name", [](const message_type& of) { return of.entry.name(); })
        .def_property_readonly(
            "code", [](const message_type& of) { return of.entry.command_code(); }, "Command code, or message ID.")
        .def_property_readonly(
            "query", [](const message_type& of) { return of.entry.query(); },
            "Code of the query that it answers; 0: it is no report.")
        .def_property_readonly(
            "report", [](const message_type& of) { return of.entry.report(); },
            "Code of the report that answers it; 0: it is no query.")
        .def_property_readonly(
            "min_size", [](const message_type& of) { return of.entry.min_size(); }, "Bytes of its body.")
        .def_property_readonly("max_size", [](const message_type& of) { return of.entry.max_size(); })
        .def_property_readonly("fields", [](const message_type& of) { return fields_of(of.entry.fields(), 0); })
        .def(
            "decode", [](const message_type& of, const py::bytes& body) { return of.decode(bytes_of(body)); }, "body"_a,
            "The message of a body; of SAE, of a payload, which begins with the message ID.")
        .def(
            "encode", [](const message_type& of, const py::dict& fields) { return to_bytes(of.encode(fields)); },
            "fields"_a = py::dict{}, "The body of these fields.")
        .def(
            "from_text", [](const message_type& of, std::string_view line) { return to_bytes(of.from_text(line)); },
            "line"_a, "The body of a line such as 'propulsive_linear_effort_x=50'.")
        .def(
            "annotate", [](const message_type& of, const py::bytes& body) { return of.entry.annotate(bytes_of(body)); },
            "body"_a, "A line for each field of a body: offset, bytes, name, value.")
        .def("__eq__", [](const message_type& a, const message_type& b) { return a.entry == b.entry; })
        .def("__hash__", [](const message_type& of) { return static_cast<py::ssize_t>(of.entry.command_code()); })
        .def("__repr__",
             [](const message_type& of) { return "<jauscat.MessageType " + std::string{of.entry.name()} + ">"; });

    module.def("messages", &messages, "generation"_a = "ra",
               "All messages of RA 3.3 ('ra'), or of the SAE services ('sae'), by ascending code.");
    module.def(
        "message", [](const py::object& name, const std::string& of) { return find(name, generation_of(of)); },
        "name"_a, "generation"_a = "ra",
        "A message by its name, 'set_wrench_effort' or 'Set Wrench Effort', or by its code.");
    module.def(
        "decode", [](const py::bytes& data, const std::string& of) { return decode(data, of); }, "data"_a,
        "generation"_a = "ra",
        "A whole message: header and body of RA 3.3, or a message of AS5669A with its transport header.");
    module.def("decode_datagram", &decode_datagram, "data"_a,
               "The messages of a UDP datagram of either generation; empty where it is none of JAUS.");
    module.def(
        "encode",
        [](const py::object& name, const py::dict& fields, const std::string& to, const std::string& source,
           bool acknowledge, std::uint16_t sequence_number, const std::string& of) {
            return to_bytes(encode(find(name, generation_of(of)), fields, {to, source, acknowledge, sequence_number}));
        },
        "name"_a, "fields"_a = py::dict{}, py::kw_only{}, "to"_a, "source"_a, "acknowledge"_a = false,
        "sequence_number"_a = 0, "generation"_a = "ra", "The bytes of a whole message, the reverse of decode.");
}

void add_tables(py::module_& module) {
    py::class_<packet>(module, "Packet", "A message as the object of an EtherCAT slave: what an SDO download carries.")
        .def_readonly("node", &packet::node, "The JAUS node, which is the slave's station address.")
        .def_readonly("index", &packet::index)
        .def_readonly("subindex", &packet::subindex)
        .def_readonly("data", &packet::data)
        .def_readonly("packet", &packet::bytes, "The Hilscher packet that requests the download.")
        .def("__repr__", [](const packet& of) {
            std::ostringstream text;
            text << "<jauscat.Packet node " << of.node << ", object " << std::hex << std::uppercase << of.index
                 << "h:" << std::dec << of.subindex << ">";
            return text.str();
        });
    module.def("translate", &to_packet, "message"_a, "table"_a = "seed", "index_base"_a = py::none{},
               "A whole message by the table 'seed', 'self-contained' or 'sae'. Index base: 6900, of sae 0x2000.");
    module.def("translate_back", &from_packet, "packet"_a, "table"_a = "seed", "index_base"_a = py::none{},
               "The message of a packet, as far as the table carries it.");
}

jauscat::node_options node_options(const std::string& config, const std::string& config_text,
                                   const std::string& this_system, bool open, bool reuse_address,
                                   const py::object& log) {
    jauscat::node_options made{.config = config,
                               .config_text = config_text,
                               .this_system = this_system,
                               .open = open,
                               .reuse_address = reuse_address,
                               .name = "jauscat"};
    made.explain_malformed = catalogue::ra_3_3().explainer();
    if (!log.is_none())
        made.log = [f = callback{log.cast<py::function>()}](std::string_view line) {
            f([&](const py::function& write) { write(to_str(line)); });
        };
    return made;
}

void add_nodes(py::module_& module) {
    py::class_<control>(module, "Control", "Control of a component, until it is released: with operator.control(...):")
        .def("send", &control::send, "name"_a, "fields"_a = py::dict{}, "Sends a command until it is acknowledged.")
        .def("release", &control::release)
        .def_property_readonly("held", &control::is_held, "Whether it is neither released nor lost.")
        .def("__enter__", [](const py::object& self) { return self; })
        .def("__exit__", [](control& self, const py::args&) { self.release(); });

    py::class_<component, std::shared_ptr<component>>(module, "Component",
                                                      "A JAUS component of a node; made by node.component.")
        .def("on", &component::on, "name"_a, "handler"_a,
             "handler(message) is called for each message of this name, by the node's thread. It returns None or True, "
             "False\n"
             "to refuse the message, or for a query the fields of its report. An exception is logged, refuses the "
             "message, and\n"
             "brings the component to Failure.")
        .def("when_stopped", &component::when_stopped, "handler"_a,
             "handler() is called when the actuators must come to rest.")
        .def("ready", &component::ready, "From Initialize or Failure to Ready: motion commands are obeyed.")
        .def("fail", &component::fail, "why"_a, "To Failure: stopped, until ready.")
        .def("send", &component::send, "to"_a, "name"_a, "fields"_a = py::dict{}, py::kw_only{},
             "acknowledged"_a = true,
             "Sends a message. Acknowledged: repeats it until it is, else raises RefusedError or NoAnswerError.")
        .def("ask", &component::ask, "of"_a, "query"_a, "fields"_a = py::dict{}, py::kw_only{}, "timeout"_a = 2.0,
             "acknowledged"_a = true, "Sends a query and returns its report.")
        .def("control", &component::take_control, "of"_a, "authority"_a = 128, "Takes control of a component.")
        .def_property_readonly("address", &component::address)
        .def_property_readonly("state", &component::state,
                               "initialize, ready, standby, shutdown, failure or emergency.")
        .def_property_readonly("controller", &component::controller,
                               "The JAUS ID of the component that has control, or None.");

    py::class_<node, std::shared_ptr<node>>(
        module, "Node", "A JAUS node of RA 3.3. It works in a thread of its own: with jauscat.Node(...) as node:")
        .def(py::init([](const std::string& config, const std::string& config_text, const std::string& this_system,
                         bool open, bool reuse_address, const py::object& log) {
                 return std::make_shared<node>(
                     node_options(config, config_text, this_system, open, reuse_address, log));
             }),
             "config"_a = "JausConfig.xml", py::kw_only{}, "config_text"_a = "", "this_system"_a = "", "open"_a = false,
             "reuse_address"_a = false, "log"_a = py::none{},
             "config: a file; config_text: the configuration itself. log(line): by default standard error.")
        .def(
            "component",
            [](node& of, std::uint8_t id, const std::string& name, std::uint8_t instance, std::uint8_t authority) {
                return of.add({.id = id, .instance = instance, .name = name, .authority = authority});
            },
            "id"_a, "name"_a = "", "instance"_a = 1, "authority"_a = 0, py::keep_alive<0, 1>{},
            "A component, which lives as long as the node. Before start.")
        .def("start", &node::start, "Opens the sockets.")
        .def("stop", &node::stop, "Stops the components and closes the sockets.")
        .def("run", &node::run, "Works until stop is called, or Ctrl-C, which stops it and raises KeyboardInterrupt.")
        .def_property_readonly("running", &node::is_running)
        .def("__enter__", [](const py::object& self) { return self.attr("start")(), self; })
        .def("__exit__", [](node& self, const py::args&) { self.stop(); });
    py::module_::import("atexit").attr("register")(py::cpp_function{&node::stop_all});
}

} // namespace

PYBIND11_MODULE(_jauscat, module) {
    module.doc() = "JAUS messages by name, their translation for EtherCAT, and JAUS nodes for test benches.";
    module.attr("__version__") = JAUSCAT_VERSION_TEXT;
    const py::object own_name = module.attr("__name__");
    module.attr("__name__") = "jauscat"; // of the package, for the names of the classes
    error_classes::all().add_to(module);
    add_messages(module);
    add_tables(module);
    add_nodes(module);
    module.attr("__name__") = own_name;
}
