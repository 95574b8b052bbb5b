// Golden messages of SAE JAUS, one message for each construct of JSIDL: bytes and values both ways, damaged bytes,
// random messages.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include "support/sae_samples.hpp"
#include <jauscat/text/json.hpp>
#include <jauscat/text/print.hpp>

#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

namespace text = jauscat::text;
namespace wire = jauscat::wire;
using json = nlohmann::ordered_json;
using wire::errc;

struct lent_memory {
    std::vector<std::byte> bytes = std::vector<std::byte>(std::size_t{1} << 20U);
    wire::arena arena{bytes};
};

/// One value of a message: a number with the size of a step, or octets in hex.
struct leaf {
    double number{};
    double step{}; ///< 0: an integer
    double* real{};
    std::string octets{};
};

template <class Codec> double step_of() {
    if constexpr (requires { typename Codec::range_type; })
        return (Codec::range_type::max - Codec::range_type::min) / (std::pow(2.0, Codec::size * 8) - 1);
    else
        return 0;
}

/// The values of a message in wire order.
class leaves {
  public:
    template <class T> void take(const T& object) {
        wire::visit(object, [&]<class Item>(Item, const auto& member) {
            if constexpr (requires { member.has_value(); }) {
                if (member) value<Item>(object, *member);
            } else {
                value<Item>(object, member);
            }
        });
    }
    std::vector<leaf> all{};

  private:
    template <class Item> void value(const auto& object, const auto& member) {
        using type = std::remove_cvref_t<decltype(member)>;
        if constexpr (requires { Item::with_case(0, [] {}); }) {
            const wire::object_scope here{object, wire::plain_root{}};
            double step = 0;
            Item::with_case(Item::selector::value(here), [&]<class Case>() { step = step_of<typename Case::form>(); });
            number(member, step);
        } else if constexpr (requires { typename Item::codec_type; }) {
            number(member, step_of<typename Item::codec_type>());
        } else if constexpr (wire::message<type>) {
            take(member);
        } else if constexpr (wire::is_variant<type>) {
            std::visit([&](const auto& held) { take(held); }, member);
        } else if constexpr (std::is_same_v<type, std::string_view>) {
            all.push_back({.octets = std::string{member}});
        } else if constexpr (std::is_same_v<type, wire::blob>) {
            all.push_back({.octets = text::detail::plain_hex(member)});
        } else if constexpr (std::is_same_v<type, wire::embedded_message>) {
            all.push_back({.octets = text::detail::plain_hex(member.bytes())});
        } else if constexpr (requires { member.size(); }) {
            for (const auto& element : member) {
                if constexpr (wire::message<std::remove_cvref_t<decltype(element)>>)
                    take(element);
                else
                    number(element, step_of<typename Item::element_type::codec_type>());
            }
        } else {
            number(member, 0);
        }
    }
    template <class Value> void number(const Value& held, double step) {
        leaf made{.number = static_cast<double>(held), .step = step};
        if constexpr (std::is_same_v<Value, double>) made.real = const_cast<double*>(&held);
        all.push_back(made);
    }
};

/// The same out of a vector. The index of a variant is no leaf: the bytes contain it.
struct expected_leaf {
    json value{};
    double input{};
};
void flatten(const json& fields, std::vector<expected_leaf>& all) {
    if (fields.is_array()) {
        for (const auto& one : fields) flatten(one, all);
    } else if (!fields.is_object()) {
        all.push_back({fields, 0});
    } else if (fields.contains("hex")) {
        if (fields.contains("index")) all.push_back({fields["index"], 0});
        all.push_back({fields["hex"], 0});
    } else if (fields.contains("raw")) {
        if (fields.contains("index")) all.push_back({fields["index"], 0});
        all.push_back({fields["value"], fields.value("input", fields["value"].get<double>())});
    } else if (fields.contains("index")) {
        if (fields.contains("value")) flatten(fields["value"], all);
    } else {
        for (const auto& [name, one] : fields.items()) flatten(one, all);
    }
}

template <wire::message T> std::vector<std::byte> encoded(const T& value) {
    std::vector<std::byte> out(wire::encoded_size(value));
    const auto written = wire::encode(value, out, wire::tolerate_values);
    REQUIRE(written);
    REQUIRE(written->size() == out.size());
    return out;
}

/// Any bytes: an error, or a message that encodes and comes back. `bytes` ends where its memory ends.
template <wire::message T> bool require_error_or_message(std::span<const std::byte> bytes, lent_memory& memory) {
    memory.arena.reset();
    T value{};
    const errc error = wire::decode(value, bytes, memory.arena, wire::tolerate_values).error();
    const errc strict = wire::decode(value, bytes, memory.arena).error();
    const errc diagnosed = wire::diagnose<T>(bytes).error;
    if (strict != diagnosed) FAIL("diagnose says " << wire::describe(diagnosed) << " for " << wire::describe(strict));
    if (error != errc::ok) {
        if (strict != error) FAIL("decode has two reasons");
        return false;
    }
    if (strict != errc::ok && strict != errc::outside_value_set) FAIL(wire::describe(strict));
    if (strict != wire::check_values(value)) FAIL("check_values differs");
    if (!wire::view<T>{bytes}) FAIL("a view refuses " << text::detail::plain_hex(bytes));
    wire::raw<T> raw{};
    if (!wire::decode(raw, bytes, memory.arena)) FAIL("a raw message refuses the bytes");
    std::vector<std::byte> out(wire::encoded_size(raw));
    if (!wire::encode(raw, out) || out.size() != bytes.size()) FAIL("a raw message has another size");
    if (strict == errc::ok) {
        const auto again = encoded(value);
        T other{};
        if (!wire::decode(other, again, memory.arena) || !(other == value)) FAIL("a message does not come back");
    }
    return true;
}

struct golden {
    json object{};
    std::vector<std::byte> bytes{};
};
const std::vector<golden>& all_golden() {
    static const auto all = [] {
        std::vector<golden> read;
        std::ifstream file{support::test_data("sae_vectors.jsonl")};
        for (std::string line; std::getline(file, line);) {
            json object = json::parse(line);
            auto bytes = jauscat::test::from_hex(object.at("hex").get<std::string>());
            read.push_back({std::move(object), std::move(bytes)});
        }
        return read;
    }();
    return all;
}
template <wire::message T> std::vector<golden> golden_of() {
    std::vector<golden> found;
    for (const auto& one : all_golden())
        if (std::stoi(one.object.at("code").get<std::string>(), nullptr, 16) == T::schema::message_id)
            found.push_back(one);
    REQUIRE(!found.empty());
    return found;
}

/// Fills a message at random.
class random_filler {
  public:
    explicit random_filler(wire::arena& memory, unsigned seed) : memory_{memory}, source_{seed} {}
    template <class T> void fill(T& object) {
        wire::visit(object, [&]<class Item>(Item, auto& member) {
            if constexpr (requires { member.has_value(); }) {
                if (roll(2) == 0)
                    member.reset();
                else
                    value<Item>(member.emplace());
            } else {
                value<Item>(member);
            }
        });
    }

  private:
    std::uint64_t roll(std::uint64_t sides) { return source_() % sides; }
    template <class Range> double real() {
        return Range::min + static_cast<double>(roll(1'000'001)) / 1e6 * (Range::max - Range::min);
    }
    std::span<std::byte> octets() {
        const std::size_t size = static_cast<std::size_t>(roll(20)) + 2;
        auto* const first = memory_.allocate<std::byte>(size);
        for (std::size_t i = 0; i != size; ++i) first[i] = static_cast<std::byte>(roll(255) + 1);
        return {first, size};
    }
    template <class Codec, class Value> void number(Value& held) {
        if constexpr (requires { typename Codec::range_type; })
            held = real<typename Codec::range_type>();
        else
            do held = static_cast<Value>(roll(1U << 16U));
            while (wire::detail::holds_value<Codec>(held) == false);
    }
    template <class Item, class Type> void value(Type& held) {
        if constexpr (requires { Item::with_case(0, [] {}); }) {
            held = real<sae::altitude>();
        } else if constexpr (requires { typename Item::codec_type; }) {
            if constexpr (std::is_same_v<typename Item::value_type, std::uint8_t>) {
                if (Item::name() == "index") {
                    held = static_cast<Type>(roll(5));
                    return;
                }
            }
            number<typename Item::codec_type>(held);
        } else if constexpr (wire::message<Type>) {
            fill(held);
        } else if constexpr (wire::is_variant<Type>) {
            wire::detail::alternatives_of<Type>::with(
                static_cast<std::size_t>(roll(std::variant_size_v<Type>)),
                [&]<std::size_t I, class>() { fill(held.template emplace<I>()); });
        } else if constexpr (std::is_same_v<Type, std::string_view>) {
            const auto bytes = octets();
            held = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
        } else if constexpr (std::is_same_v<Type, wire::blob> || std::is_same_v<Type, wire::embedded_message>) {
            held = Type{octets()};
        } else if constexpr (requires { wire::list_traits<Type>::counted; }) {
            if constexpr (wire::list_traits<Type>::elsewhere) {
                using element = typename wire::list_traits<Type>::value_type;
                const std::size_t size = static_cast<std::size_t>(roll(4));
                auto* const first = memory_.allocate<element>(size);
                for (std::size_t i = 0; i != size; ++i) fill(first[i]);
                held = std::span<const element>{first, size};
            } else {
                for (auto& element : held) number<typename Item::element_type::codec_type>(element);
            }
        } else {
            do held = static_cast<Type>(roll(std::uint64_t{1} << Item::width));
            while (!wire::detail::in_its_set<Item>(held));
        }
    }

    wire::arena& memory_;
    std::mt19937 source_;
};

} // namespace

#define MESSAGES                                                                                                       \
    sae::create_event, sae::query_events, sae::reject_event_request, sae::set_element, sae::set_local_operating_zone,  \
        sae::report_sensor_geometric_properties, sae::report_gps_fix, sae::report_range_sensor_data,                   \
        sae::report_range_sensor_compressed_data

TEMPLATE_TEST_CASE("golden messages of SAE JAUS agree in every byte and value", "", MESSAGES) {
    for (const auto& one : golden_of<TestType>()) {
        CAPTURE(one.object.dump());
        lent_memory memory;
        TestType value{};
        REQUIRE(wire::describe(wire::decode(value, one.bytes, memory.arena).error()) == "ok");
        REQUIRE(encoded(value) == one.bytes);
        REQUIRE(wire::diagnose<TestType>(one.bytes));
        REQUIRE(wire::diagnose(value));

        leaves found;
        found.take(value);
        std::vector<expected_leaf> expected;
        flatten(one.object.at("fields"), expected);
        REQUIRE(found.all.size() == expected.size());
        for (std::size_t i = 0; i != expected.size(); ++i) {
            CAPTURE(i);
            const leaf& is = found.all[i];
            const json& must = expected[i].value;
            if (must.is_string())
                REQUIRE(is.octets == must.get<std::string>());
            else if (is.step == 0)
                REQUIRE(is.number == must.get<double>());
            else
                REQUIRE(std::abs(is.number - must.get<double>()) < is.step / 10);
            if (is.step != 0) *is.real = expected[i].input; // rounds to the same integer
        }
        REQUIRE(encoded(value) == one.bytes);
    }
}

TEMPLATE_TEST_CASE("damaged messages of SAE JAUS are refused or are other messages", "", MESSAGES) {
    lent_memory memory;
    for (const auto& one : golden_of<TestType>()) {
        for (std::size_t size = 0; size != one.bytes.size(); ++size) {
            const std::vector<std::byte> shorter(one.bytes.begin(),
                                                 one.bytes.begin() + static_cast<std::ptrdiff_t>(size));
            TestType value{};
            memory.arena.reset();
            REQUIRE(wire::decode(value, shorter, memory.arena).error() == errc::truncated);
            REQUIRE(wire::view<TestType>{shorter}.error() == errc::truncated);
            REQUIRE(wire::diagnose<TestType>(shorter).error == errc::truncated);
        }
        const unsigned every = one.bytes.size() < 100 ? 1 : 17;
        for (std::size_t at = 0; at != one.bytes.size(); ++at)
            for (unsigned change = 1; change < 256; change += every) {
                auto changed = one.bytes;
                changed[at] ^= static_cast<std::byte>(change);
                require_error_or_message<TestType>(changed, memory);
            }
    }
    SUCCEED();
}

TEMPLATE_TEST_CASE("random messages of SAE JAUS come back, as bytes and as JSON", "", MESSAGES) {
    lent_memory memory, other;
    for (unsigned seed = 0; seed != 200; ++seed) {
        CAPTURE(seed);
        memory.arena.reset();
        TestType value{};
        random_filler{memory.arena, seed}.fill(value);
        REQUIRE(wire::check_values(value) == errc::ok);
        const auto bytes = encoded(value);
        TestType found{};
        REQUIRE(wire::describe(wire::decode(found, bytes, memory.arena).error()) == "ok");
        REQUIRE(encoded(found) == bytes);
        REQUIRE(require_error_or_message<TestType>(bytes, other));

        TestType read{};
        const auto done = text::from_json(text::to_json(found), read, memory.arena);
        if (!done) FAIL(done.error().message);
        REQUIRE(encoded(read) == bytes);
        REQUIRE(!text::to_text(found).empty());
    }
}
