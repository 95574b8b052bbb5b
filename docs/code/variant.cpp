// Step 6 of declare-a-message.md: a value whose form another member selects.
// [includes]
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>
#include <variant>

// [includes end]

// [declare]
enum class goal_type : std::uint8_t { width = 0, object = 1, release = 255 };

struct object_goal {
    std::uint8_t number{};
    std::uint8_t grip{};

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = object_goal;
        using type = layout<
            field<&T::number, u8>,
            field<&T::grip, u8>>;
    };
    // clang-format on
};

struct set_goal {
    goal_type type{};
    std::variant<std::uint16_t, object_goal, std::monostate> goal{};

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = set_goal;
        using type = layout<
            field<&T::type, enumeration<goal_type, u8>>,
            selected<&T::goal, by<&T::type>,
                when<goal_type::width, u16le>,
                when<goal_type::object, object_goal>,
                when<goal_type::release>>>; // no bytes
    };
    // clang-format on
};
// [declare end]

int main() {
    // [use]
    std::array<std::byte, 8> buffer{};
    for (const set_goal& goal : {set_goal{goal_type::width, std::uint16_t{80}},
                                 set_goal{goal_type::object, object_goal{.number = 7, .grip = 2}},
                                 set_goal{goal_type::release, std::monostate{}}}) {
        const auto encoded = jauscat::wire::encode(goal, buffer);
        std::cout << jauscat::text::annotate<set_goal>(*encoded) << '\n';
    }

    // The type of the value does not match its tag.
    const auto written = jauscat::wire::encode(set_goal{goal_type::width, object_goal{}}, buffer);
    std::cout << describe(written.error()) << '\n';
    // [use end]
}
