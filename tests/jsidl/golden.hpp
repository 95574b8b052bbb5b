// Golden messages of SAE services: each vector decodes to its values, and encodes to its bytes.
#pragma once
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include <jauscat/jsidl/names.hpp>
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/wire/wire.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace golden_sae {

namespace wire = jauscat::wire;
using json = nlohmann::ordered_json;

/// The vectors of the services whose URI begins with `prefix`.
inline std::vector<json> vectors(const std::string& prefix) {
    std::vector<json> read;
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) {
        auto one = json::parse(line);
        if (one.at("service").get<std::string>().starts_with(prefix)) read.push_back(std::move(one));
    }
    return read;
}

template <class T>
concept choice_structure = requires(T value) {
    value.index;
    value.value;
};
template <class T>
concept formatted_structure = requires(T value) {
    value.format;
    value.data;
};
template <class T>
concept variant_structure =
    requires(T value) { requires wire::is_variant<std::remove_cvref_t<decltype(value.value)>>; };
template <class T> concept list_structure = requires(T value) { value.elements; };

/// A step of a scaled number; 0 for other codecs.
template <class Codec> constexpr double step_of() {
    if constexpr (requires { typename Codec::range_type; })
        return (Codec::range_type::max - Codec::range_type::min) / static_cast<double>(Codec::top);
    else
        return 0;
}

/// Compares a decoded message with the fields of its vector.
class comparison {
  public:
    /// Real numbers become what the vector gives as another number with the same integer.
    bool with_inputs{};

    template <class T> void message(T& value, const json& fields) {
        if (fields.empty()) {
            CHECK(wire::max_size<T> == 2);
            return;
        }
        const auto& body = *fields.begin();
        std::size_t members = 0;
        bool is_inner = body.is_array();
        wire::visit(value, [&]<class Item>(Item, auto& member) {
            ++members;
            is_inner = is_inner || wire::is_variant<std::remove_cvref_t<decltype(member)>>;
        });
        if (members == 1 && is_inner && (body.is_array() || body.contains("index")))
            wire::visit(value, [&]<class Item>(Item, auto& member) {
                if constexpr (!requires { member.has_value(); }) this->template any<Item>(member, body);
            });
        else
            record(value, body);
    }

  private:
    template <class T> void record(T& value, const json& fields) {
        REQUIRE(fields.is_object());
        std::map<std::string, const json*> by_name;
        for (const auto& [name, field] : fields.items()) {
            auto member = jauscat::jsidl::identifier(name, "field");
            if (member.ends_with('_')) member.pop_back(); // a keyword: its member's name is without in text
            by_name[member] = &field;
        }
        wire::visit(value, [&]<class Item>(Item, auto& member) {
            const std::string name{Item::name()};
            INFO(name);
            const auto found = by_name.find(name);
            if constexpr (requires { member.has_value(); }) {
                REQUIRE(member.has_value() == (found != by_name.end()));
                if (member) this->template any<Item>(*member, *found->second);
            } else {
                REQUIRE(found != by_name.end());
                this->template any<Item>(member, *found->second);
            }
            by_name.erase(name);
        });
        CHECK(by_name.empty());
    }
    void real(double& value, const json& field, double step) {
        REQUIRE(std::abs(value - field.at("value").get<double>()) <= step / 10);
        if (with_inputs && field.contains("input")) value = field.at("input");
    }
    template <class Item, class T> void any(T& value, const json& field) {
        if constexpr (std::is_same_v<T, std::string_view>) {
            CHECK(value == field.get<std::string>());
        } else if constexpr (std::is_same_v<T, wire::blob>) {
            CHECK(jauscat::test::to_hex(value) ==
                  jauscat::test::to_hex(jauscat::test::from_hex(field.at("hex").get<std::string>())));
        } else if constexpr (std::is_same_v<T, double>) {
            if constexpr (requires { typename Item::codec_type; })
                real(value, field, step_of<typename Item::codec_type>());
            else
                real(value, field, step_of<typename Item::element_type>());
        } else if constexpr (std::is_same_v<T, wire::embedded_message>) {
            auto bytes = value.bytes();
            any<Item>(bytes, field);
        } else if constexpr (wire::is_variant<T>) {
            REQUIRE(value.index() == field.at("index").get<std::size_t>());
            std::visit(
                [&](auto& one) {
                    if (field.contains("value"))
                        inner(one, field.at("value"));
                    else // it has no alternative
                        CHECK(std::is_empty_v<std::remove_cvref_t<decltype(one)>>);
                },
                value);
        } else if constexpr (choice_structure<T>) {
            REQUIRE(static_cast<std::uint64_t>(value.index) == field.at("index").get<std::uint64_t>());
            wire::visit(value, [&]<class Selected>(Selected, auto&) {
                if constexpr (requires { typename Selected::cases; })
                    Selected::with_case(
                        value.index, [&]<class Case>() { real(value.value, field, step_of<typename Case::form>()); });
            });
        } else if constexpr (formatted_structure<T>) {
            REQUIRE(static_cast<std::uint64_t>(value.format) == field.at("index").get<std::uint64_t>());
            any<Item>(value.data, field);
        } else if constexpr (std::is_enum_v<T> || std::integral<T>) {
            CHECK(static_cast<std::uint64_t>(value) == field.get<std::uint64_t>());
        } else if constexpr (requires { value.begin(); }) {
            REQUIRE(field.size() == value.size());
            for (std::size_t i = 0; i != value.size(); ++i) {
                INFO("element " << i);
                // The elements of a list are in this test's memory.
                auto& one = const_cast<std::remove_const_t<std::remove_reference_t<decltype(value[i])>>&>(value[i]);
                if constexpr (std::is_class_v<std::remove_cvref_t<decltype(one)>>)
                    inner(one, field[i]);
                else
                    any<Item>(one, field[i]);
            }
        } else {
            inner(value, field);
        }
    }
    template <class T> void inner(T& value, const json& field) {
        if constexpr (list_structure<T>)
            any<void>(value.elements, field);
        else if constexpr (variant_structure<T>)
            any<void>(value.value, field);
        else if constexpr (std::is_empty_v<T>)
            CHECK(field.at("index") == 0);
        else
            record(value, field);
    }
};

template <wire::message T> void check(const json& vector) {
    INFO(vector.at("service").get<std::string>()
         << ' ' << vector.at("message").get<std::string>() << ' ' << vector.at("hex").get<std::string>());
    const auto bytes = jauscat::test::from_hex(vector.at("hex").get<std::string>());

    static std::vector<std::byte> memory(1 << 20);
    wire::arena arena{memory};
    T value{};
    REQUIRE(wire::decode(value, bytes, arena).error() == wire::errc::ok);
    for (const bool with_inputs : {false, true}) {
        comparison{with_inputs}.message(value, vector.at("fields"));
        std::vector<std::byte> again(wire::encoded_size(value));
        REQUIRE(wire::encode(value, again));
        REQUIRE(jauscat::test::to_hex(again) == jauscat::test::to_hex(bytes));
    }
}

/// All vectors of a set; returns how many there are.
template <class... Messages>
std::size_t check_all(const std::string& prefix, jauscat::jaus::message_list<Messages...>) {
    const auto all = vectors(prefix);
    std::set<std::uint16_t> codes;
    for (const auto& vector : all) {
        const auto code = static_cast<std::uint16_t>(std::stoi(vector.at("code").get<std::string>(), nullptr, 16));
        codes.insert(code);
        const bool is_known = ((code == Messages::schema::message_id && (check<Messages>(vector), true)) || ...);
        INFO(vector.at("message").get<std::string>());
        CHECK(is_known);
    }
    CHECK(codes.size() == sizeof...(Messages));
    return all.size();
}

} // namespace golden_sae
