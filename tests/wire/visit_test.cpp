// Walking over members, and their names.
#include "both_ways.hpp"
#include "samples.hpp"
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <string>
#include <vector>

using samples::mixed;

namespace {

struct inner_type {
    std::uint8_t inner_member{};
};
template <class T> struct wrapper {
    T wrapped_member{};
};

template <wire::message T> std::vector<std::string> names_of_members() {
    std::vector<std::string> names;
    const T value{};
    wire::visit(value, [&]<class Item>(Item, const auto&) { names.emplace_back(Item::name()); });
    return names;
}

} // namespace

TEST_CASE("visit calls for each member once, in wire order, with its name") {
    REQUIRE(names_of_members<samples::scalars>() ==
            std::vector<std::string>{"small", "little", "big", "single_precision", "shade", "error", "station"});
    REQUIRE(names_of_members<samples::flags>() == std::vector<std::string>{"length", "shade", "circulating"});
    REQUIRE(names_of_members<mixed>() == std::vector<std::string>{"number", "level", "required", "place", "id"});
    REQUIRE(names_of_members<samples::envelope>() == std::vector<std::string>{"kind", "content", "tail"});
    REQUIRE(names_of_members<jauscat::jaus::header>() ==
            std::vector<std::string>{"priority", "ack_nak", "service_connection", "experimental", "version", "reserved",
                                     "command_code", "destination", "source", "data_size", "data_flag",
                                     "sequence_number"});
    REQUIRE(names_of_members<samples::empty>().empty());
}

TEST_CASE("visit calls for the same members of a raw message") {
    REQUIRE(names_of_members<wire::raw<mixed>>() == names_of_members<mixed>());
}

TEST_CASE("visit passes the member itself") {
    both_ways([] {
        samples::scalars value{};
        wire::visit(value, [](auto, auto& member) {
            if constexpr (std::integral<std::remove_cvref_t<decltype(member)>>) member = 9;
        });
        return value.small == 9 && value.little == 9 && value.big == 9 && value.single_precision == 0.0f;
    });
}

TEST_CASE("visit passes the carrier of a member") {
    std::size_t widths = 0, optionals = 0, structures = 0, bytes_of_codecs = 0;
    const auto count = [&]<class Item>(Item, const auto&) {
        if constexpr (requires { Item::width; }) widths += Item::width;
        if constexpr (requires { typename Item::inner; }) ++structures;
        if constexpr (requires { typename Item::codec_type; }) bytes_of_codecs += Item::codec_type::size;
        optionals += Item::optional;
    };
    const samples::flags bit_fields{};
    wire::visit(bit_fields, count);
    REQUIRE(widths == 14);
    const mixed value{};
    wire::visit(value, count);
    REQUIRE(optionals == 3);
    REQUIRE(structures == 1);
    REQUIRE(bytes_of_codecs == 1 + 1 + 2 + 4);
}

TEST_CASE("names of members are derived from the compiler's spelling of their pointers") {
    STATIC_REQUIRE(wire::name_of<&mixed::level>() == "level");
    STATIC_REQUIRE(wire::name_of<&jauscat::jaus::set_wrench_effort::resistive_rotational_effort_z>() ==
                   "resistive_rotational_effort_z");
    STATIC_REQUIRE(wire::name_of<&inner_type::inner_member>() == "inner_member");
    STATIC_REQUIRE(wire::name_of<&wrapper<std::optional<int>>::wrapped_member>() == "wrapped_member");
    STATIC_REQUIRE(wire::member_name<&mixed::id> == "id");
}

TEST_CASE("names of types have no namespaces") {
    STATIC_REQUIRE(wire::type_name<mixed>() == "mixed");
    STATIC_REQUIRE(wire::type_name<jauscat::jaus::set_wrench_effort>() == "set_wrench_effort");
    STATIC_REQUIRE(wire::type_name<inner_type>() == "inner_type");
    STATIC_REQUIRE(wire::type_name<int>() == "int");
}

template <class T, std::size_t Count>
constexpr bool has_members = !wire::has_more_members_than<T, Count> && wire::has_more_members_than<T, Count - 1>;

TEST_CASE("the number of members of an aggregate is counted for all member types") {
    STATIC_REQUIRE(!wire::has_more_members_than<samples::empty, 0>);
    STATIC_REQUIRE(has_members<samples::scalars, 7>);
    STATIC_REQUIRE(has_members<mixed, 5>);
    STATIC_REQUIRE(has_members<samples::envelope, 3>);
    STATIC_REQUIRE(has_members<jauscat::jaus::header, 12>);
    STATIC_REQUIRE(has_members<jauscat::jaus::set_wrench_effort, 12>);
    STATIC_REQUIRE(has_members<jauscat::jaus::report_global_pose, 9>);
}
