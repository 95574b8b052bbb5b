// Run-time description of a message: names, units, limits and access to each member, without its type. Made from a
// schema once (see describe.hpp); what prints, parses or documents any message is written against it and compiled once,
// not once for each of 158 messages.
#pragma once
#include <jauscat/text/error.hpp>
#include <jauscat/wire/arena.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace jauscat::text {

struct structure;
struct form;

/// Numbers of a value set, both included; negative ones in two's complement.
struct number_range {
    std::uint64_t least{}, most{};
};

/// An integer of up to 64 bits; also enumerations, sets of flags and bool.
struct integer_form {
    enum class meaning : std::uint8_t { number, enumeration, flags, boolean };
    meaning what{};                            ///< meaning of the integer
    bool is_signed{};                          ///< in two's complement
    unsigned bits{};                           ///< of the value on the wire
    std::string_view unit{};                   ///< empty: none
    std::span<const std::string_view> names{}; ///< of enumerators or bits, by number; empty where one has no name
    std::string_view type{};                   ///< name of the enumeration of `names`
    std::span<const number_range> values{};    ///< its value set; empty: all
    std::uint64_t (*get)(const void* value){}; ///< a negative number in two's complement
    void (*set)(void* value, std::uint64_t){};
};

/// Whether a number is outside the value set.
[[nodiscard]] constexpr bool is_outside(const integer_form& form, std::uint64_t number) noexcept {
    for (const auto [least, most] : form.values) {
        const bool below =
            form.is_signed ? static_cast<std::int64_t>(number) < static_cast<std::int64_t>(least) : number < least;
        const bool above =
            form.is_signed ? static_cast<std::int64_t>(number) > static_cast<std::int64_t>(most) : number > most;
        if (!below && !above) return false;
    }
    return !form.values.empty();
}

/// A floating-point number that travels as it is.
struct real_form {
    std::string_view unit{};                         ///< empty: none
    double most{std::numeric_limits<double>::max()}; ///< largest finite number it holds
    unsigned bits{};                                 ///< on the wire
    double (*get)(const void* value){};
    void (*set)(void* value, double){};
};

/// A real number carried by an integer.
struct scaled_form {
    std::string_view unit{};    ///< empty: none
    double min{}, max{};        ///< limits by the standard
    double lowest{}, highest{}; ///< limits of what encodes: wider by rounding
    bool is_signed{};           ///< the integer
    unsigned bits{};            ///< of the integer
    double (*get)(const void* value){};
    void (*set)(void* value, double){};
    std::uint64_t (*to_raw)(double real){}; ///< of a number within the limits; negative in two's complement
    double (*to_real)(std::uint64_t raw){};
};

/// Characters or bytes.
struct octets_form {
    bool characters{};           ///< text; else bytes
    std::size_t least{}, most{}; ///< how many there may be
    bool zero_filled{};          ///< zeros at the end are not part of the value
    bool zero_terminated{};      ///< may not contain a zero
    bool to_the_end{};           ///< of the body; `zero_filled`: as many or fewer are received
    std::span<const std::byte> (*get)(const void* value){};
    void (*set)(void* value, std::span<const std::byte>){}; ///< may keep pointing at them
};

/// A structure with members of its own.
struct structure_form {
    const structure* of{}; ///< its members
};

/// A structure of bit-fields in one integer: a time stamp.
struct packed_form {
    const structure* of{}; ///< the structure with the bit-fields
    unsigned bits{};       ///< of the integer
    std::uint64_t (*get)(const void* value){};
    void (*set)(void* value, std::uint64_t){};
    std::string (*show)(const void* value){};                         ///< nullptr where it has no notation of its own
    result<void, errc> (*read)(void* value, std::string_view text){}; ///< the same notation back
};

/// A structure shown as bytes: a message inside a message.
struct encoded_form {
    const structure* of{};                                     ///< its members; nullptr: of any message
    std::vector<std::byte> (*encode)(const void* value){};     ///< empty where it does not encode
    bool (*decode)(void* value, std::span<const std::byte>){}; ///< may keep pointing at the bytes
};

/// Any number of the same, or always as many (`least` is `most`).
struct list_form {
    const form* element{};    ///< form of an element
    std::string_view field{}; ///< name of the value in an element; empty where elements are structures themselves
    std::size_t stride{};     ///< bytes from one element to the next
    std::size_t least{};      ///< how many there must be
    std::size_t most{};       ///< how many there may be
    std::size_t (*size)(const void* list){};
    const void* (*first)(const void* list){};
    /// The first of `size` new elements, which is within the limits; nullptr: no room.
    void* (*resize)(void* list, std::size_t size, wire::arena&){};
};

/// A member of the structure `owner`, by its id: the current one or an enclosing one.
struct other_member {
    const void* owner{};     ///< nullptr: there is none, or `name` is a path into another member
    std::string_view name{}; ///< of the member
    std::uint64_t (*get)(const void* object){};
    void (*set)(void* object, std::uint64_t){};
};

/// Nodes of one structure, depth first; the rest as in a list.
struct tree_form {
    list_form nodes{};       ///< form of the nodes
    std::size_t max_depth{}; ///< most levels
    other_member children{}; ///< the node's member that counts them
};

/// A case of choice_form.
struct choice_case {
    std::uint64_t tag{};                     ///< the value that selects it
    const form* how{};                       ///< nullptr: the case has no value
    const void* (*get)(const void* value){}; ///< nullptr where another case is held
    void* (*make)(void* value){};
};
/// A value in one of several forms; a member elsewhere selects it.
struct choice_form {
    std::span<const choice_case> cases{}; ///< all of them
};

/// An alternative of variant_form.
struct alternative {
    std::string_view name{}; ///< of its type
    const form* how{};       ///< nullptr: it has no value
};
/// One of several structures, with its number before it on the wire.
struct variant_form {
    std::span<const alternative> alternatives{}; ///< by number
    unsigned bits{};                             ///< of the number
    std::size_t (*index)(const void* value){};   ///< of the one that is held
    const void* (*get)(const void* value){};     ///< the one that is held
    void* (*make)(void* value, std::size_t index){};
};

/// Text form of a value.
struct form {
    std::variant<integer_form, real_form, scaled_form, octets_form, structure_form, packed_form, encoded_form,
                 list_form, tree_form, choice_form, variant_form>
        is; ///< which of these
};

/// A member of a structure, in wire order.
struct member {
    /// Kind of a member.
    enum class role : std::uint8_t {
        value,           ///< an ordinary member
        flag,            ///< a bool that only shows in the presence vector
        not_on_wire,     ///< does not travel
        count,           ///< no member: how many the next one has
        constant,        ///< no member: always the same number
        presence_vector, ///< no member: which of the following optional ones are there
    };
    role what{};                                   ///< what kind of member it is
    std::string_view name{};                       ///< as in the message's struct
    const form* how{};                             ///< of what is no member: an integer_form without get and set
    bool optional{};                               ///< may be absent: by its presence bit or its gate
    const void* (*find)(const void* object){};     ///< its value; nullptr where absent
    void* (*make)(void* object){};                 ///< its value, made present
    std::uint64_t (*number)(const void* object){}; ///< of what is no member
    other_member gate{};                           ///< the flag that announces it
    other_member counter{};                        ///< the member with its number of elements
    std::size_t counter_excess{};                  ///< by how much the counter is larger
    other_member tag{};                            ///< the member that selects among a choice_form's cases
    std::size_t least{}, most{};                   ///< bytes on the wire where it is present; 0 for a bit-field
    std::optional<unsigned> presence_bit{};        ///< of the presence vector before it
    unsigned first_bit{}, carrier_bits{};          ///< of a bit-field: where it begins in an integer of so many bits
    bool ends_carrier{};                           ///< of a bit-field: the last one in its integer
    unsigned used_bits{};                          ///< of a presence vector: so many have a meaning
    bool tolerant{}; ///< of a presence vector: other bits are dropped, with the bytes they stand for
};

/// Description of a message or another structure.
struct structure {
    const void* id{};                  ///< the same for the same type
    std::string_view name{};           ///< of its type
    std::span<const member> members{}; ///< in wire order
    std::size_t least{}, most{};       ///< bytes
};

/// A structure with its value, and the enclosing scope.
struct scope {
    const void* id{};     ///< that of the structure
    const void* object{}; ///< the value
    const scope* outer{}; ///< the structure around it; nullptr: none
};

/// The case that a choice_form member holds; `how` and `at` are nullptr where it has no value, `known` is false where
/// the tag has no case or the value is of another one.
struct held_case {
    const form* how{}; ///< see above
    const void* at{};  ///< see above
    bool known{};      ///< see above
};
[[nodiscard]] inline held_case case_of(const member& one, const void* value, const scope* around) {
    while (around != nullptr && around->id != one.tag.owner) around = around->outer;
    if (around == nullptr) return {};
    const std::uint64_t tag = one.tag.get(around->object);
    for (const choice_case& candidate : std::get<choice_form>(one.how->is).cases) {
        if (candidate.tag != tag) continue;
        const void* const at = candidate.get(value);
        return {candidate.how, at, at != nullptr};
    }
    return {};
}

} // namespace jauscat::text
