// A small service definition, written for these tests.
#pragma once
#include <jauscat/jsidl/read_jsidl.hpp>

#include <string>
#include <string_view>

namespace sample {

/// A message with the header that each message has.
inline std::string message(std::string_view body,
                           std::string_view attributes = R"(name="ReportDepth" message_id="D101")") {
    return "<message_def " + std::string{attributes} + R"( is_command="false">
<header name="h"><record name="r" optional="false"><fixed_field name="MessageID" optional="false" field_type="unsigned short integer" field_units="one"/></record></header>
<body name="Body">)" +
           std::string{body} + R"(</body>
<footer name="Footer"/>
</message_def>
)";
}

/// A service with these messages as inputs. `before` stands before its message set.
inline std::string service(std::string_view messages, std::string_view before = "",
                           std::string_view id = R"(name="Sonar" id="urn:acme:jss:survey:Sonar" version="1.0")") {
    return R"(<?xml version="1.0"?>
<service_def )" +
           std::string{id} + R"( xmlns="urn:jaus:jsidl:1.1">
)" + std::string{before} +
           "<message_set><input_set>\n" + std::string{messages} +
           "</input_set><output_set/></message_set>\n</service_def>\n";
}

/// One message whose body is a record with these fields.
inline std::string fields(std::string_view text) {
    return service(message("<record name=\"DepthRec\">\n" + std::string{text} + "</record>"));
}

using services = jauscat::result<std::vector<jauscat::jsidl::service>, jauscat::jsidl::error>;

inline services read(std::vector<std::string> texts) {
    std::vector<jauscat::jsidl::jsidl_text> named;
    for (auto& each : texts) named.push_back({std::move(each), "file" + std::to_string(named.size() + 1) + ".xml"});
    return jauscat::jsidl::parse_jsidl(named);
}

/// Why the files are refused: code and message.
inline std::string complaint(std::vector<std::string> texts) {
    const auto read_services = read(std::move(texts));
    return read_services ? "accepted" : read_services.error().message;
}

} // namespace sample
