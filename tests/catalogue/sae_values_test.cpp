// Golden messages of SAE services: each vector decodes to its values, and encodes to its bytes.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/jsidl/names.hpp>

#include <cmath>
#include <fstream>
#include <map>

namespace {

namespace catalogue = jauscat::catalogue;
namespace text = jauscat::text;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using text::json;
using role = text::member::role;

const text::member* member_named(const text::structure& type, std::string_view name) {
    for (const auto& one : type.members)
        if (one.what == role::value && one.name == name) return &one;
    return nullptr;
}
bool has_fields(const text::structure& type) {
    return std::ranges::any_of(type.members, [](const auto& one) { return one.what == role::value; });
}

/// Compares a decoded message with the fields of its vector.
class comparison {
  public:
    /// `with_inputs`: real numbers become what the vector gives as another number with the same integer.
    explicit comparison(bool with_inputs) : with_inputs_{with_inputs} {}

    void message(const text::structure& type, const void* object, const json& fields) {
        if (fields.empty()) {
            CHECK(type.most == 2);
            return;
        }
        const auto& body = *fields.begin();
        std::vector<const text::member*> members;
        for (const auto& one : type.members)
            if (one.what == role::value) members.push_back(&one);
        const bool is_inner =
            body.is_array() || (members.size() == 1 && std::holds_alternative<text::variant_form>(members[0]->how->is));
        if (members.size() == 1 && is_inner && (body.is_array() || body.contains("index")))
            value(*members[0]->how, members[0]->find(object), body);
        else
            record(type, object, body);
    }

  private:
    void record(const text::structure& type, const void* object, const json& fields) {
        REQUIRE(fields.is_object());
        std::map<std::string, const json*> by_name;
        for (const auto& [name, field] : fields.items()) {
            auto member = jauscat::jsidl::identifier(name, "field");
            if (member.ends_with('_')) member.pop_back(); // a keyword: its member's name is without in text
            by_name[member] = &field;
        }
        for (const auto& one : type.members) {
            if (one.what != role::value) continue;
            INFO(one.name);
            const auto found = by_name.find(std::string{one.name});
            const void* const held = one.find(object);
            REQUIRE((held != nullptr) == (found != by_name.end()));
            if (held == nullptr) continue;
            value(*one.how, held, *found->second);
            by_name.erase(found);
        }
        CHECK(by_name.empty());
    }
    void value(const text::form& how, const void* at, const json& field) {
        std::visit([&](const auto& form) { held(form, at, field); }, how.is);
    }

    void held(const text::integer_form& form, const void* at, const json& field) {
        CHECK(form.get(at) == field.get<std::uint64_t>());
    }
    void held(const text::real_form& form, const void* at, const json& field) {
        CHECK(form.get(at) == field.at("value").get<double>());
    }
    void held(const text::scaled_form& form, const void* at, const json& field) {
        const double step = std::abs(form.to_real(1) - form.to_real(0));
        REQUIRE(std::abs(form.get(at) - field.at("value").get<double>()) <= step / 10);
        // The objects are this test's.
        if (with_inputs_ && field.contains("input")) form.set(const_cast<void*>(at), field.at("input").get<double>());
    }
    void held(const text::octets_form& form, const void* at, const json& field) {
        const auto bytes = form.get(at);
        if (form.characters)
            CHECK(field.get<std::string>() == std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        else
            CHECK(to_hex(bytes) == to_hex(from_hex(field.at("hex").get<std::string>())));
    }
    void held(const text::encoded_form& form, const void* at, const json& field) {
        CHECK(to_hex(form.encode(at)) == to_hex(from_hex(field.at("hex").get<std::string>())));
    }
    void held(const text::list_form& form, const void* at, const json& field) {
        REQUIRE(field.size() == form.size(at));
        const auto* const first = static_cast<const std::byte*>(form.first(at));
        for (std::size_t i = 0; i != field.size(); ++i) {
            INFO("element " << i);
            value(*form.element, first + i * form.stride, field[i]);
        }
    }
    void held(const text::variant_form& form, const void* at, const json& field) {
        REQUIRE(form.index(at) == field.at("index").get<std::size_t>());
        const auto* const how = form.alternatives[form.index(at)].how;
        if (field.contains("value"))
            value(*how, form.get(at), field.at("value"));
        else if (how != nullptr) // it has no alternative
            CHECK_FALSE(has_fields(*std::get<text::structure_form>(how->is).of));
    }
    void held(const text::packed_form& form, const void* at, const json& field) { record(*form.of, at, field); }
    void held(const text::structure_form& form, const void* at, const json& field) {
        const auto& type = *form.of;
        if (!has_fields(type)) {
            CHECK(field.at("index") == 0);
        } else if (const auto* const elements = member_named(type, "elements")) {
            value(*elements->how, elements->find(at), field);
        } else if (const auto* const index = member_named(type, "index"), * const one = member_named(type, "value");
                   one != nullptr && std::holds_alternative<text::variant_form>(one->how->is)) {
            value(*one->how, one->find(at), field);
        } else if (index != nullptr && one != nullptr) { // the index selects the value's scale
            value(*index->how, index->find(at), field.at("index"));
            const text::scope here{type.id, at, nullptr};
            const auto selected = text::case_of(*one, one->find(at), &here);
            REQUIRE(selected.known);
            value(*selected.how, selected.at, field);
        } else if (const auto* const format = member_named(type, "format"), * const data = member_named(type, "data");
                   format != nullptr && data != nullptr) {
            value(*format->how, format->find(at), field.at("index"));
            value(*data->how, data->find(at), field);
        } else {
            record(type, at, field);
        }
    }
    void held(const text::tree_form&, const void*, const json&) { FAIL("no service has one"); }
    void held(const text::choice_form&, const void*, const json&) { FAIL("beside its index only"); }

    bool with_inputs_;
};

} // namespace

TEST_CASE("every golden message of SAE decodes to its values and encodes to its bytes") {
    std::map<std::string, std::size_t> counts; // by set
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) {
        const auto vector = json::parse(line);
        const auto service = vector.at("service").get<std::string>();
        INFO(service << ' ' << vector.at("message").get<std::string>() << ' ' << vector.at("hex").get<std::string>());
        const auto payload = from_hex(vector.at("hex").get<std::string>());
        const auto code = std::stoul(vector.at("code").get<std::string>(), nullptr, 16);
        const auto* const type = catalogue::sae().find(static_cast<std::uint16_t>(code));
        REQUIRE(type != nullptr);
        const auto message = type->decode(payload);
        REQUIRE(message);
        for (const bool with_inputs : {false, true}) {
            comparison{with_inputs}.message(type->fields(), message->object(), vector.at("fields"));
            REQUIRE(to_hex(*message->encode()) == to_hex(payload));
        }
        const auto set = service.find(':', std::string_view{"urn:jaus:jss:"}.size());
        ++counts[service.substr(0, set)];
    }
    CHECK(counts == std::map<std::string, std::size_t>{{"urn:jaus:jss:core", 182},
                                                       {"urn:jaus:jss:environmentSensing", 374},
                                                       {"urn:jaus:jss:manipulator", 172},
                                                       {"urn:jaus:jss:mobility", 571},
                                                       {"urn:jaus:jss:ugv", 145}});
}
