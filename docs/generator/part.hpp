// What the reference tells about a message, made from its description by describe.hpp.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::reference {

/// The names of an enumeration's values, or of the bits of a set of flags.
struct enumeration {
    struct entry {
        std::uint64_t number{};
        std::string_view name{};
    };
    std::string name{}; ///< of the type
    bool of_bits{};
    std::vector<entry> entries{};
};

/// Some consecutive bytes of a message, or bits of an integer.
struct part {
    enum class kind : std::uint8_t {
        value,           ///< a number, an enumeration, a set of flags
        packed,          ///< an integer whose bits are `parts`
        bits,            ///< a bit-field; without a name: reserved
        presence_vector, ///< says which parts with a `presence` are there
        flag,            ///< a bit of the presence vector, without bytes
        count,           ///< how many elements follow
        octets,          ///< characters or bytes
        record,          ///< a structure: `parts`
        list,            ///< `parts`, any number of times
        choice,          ///< one of `parts`, each for the tags in its own `tags`
    };
    kind what{};
    std::string name{};
    std::string owner{};                ///< the structure whose member it is; empty for what is no member
    std::size_t least{}, most{};        ///< bytes, when it is there
    std::string type{};                 ///< on the wire: u16, or the structure's name
    std::string unit{};                 ///< as the schema has it: rad/s
    std::string range{};                ///< of the value
    std::string step{};                 ///< of a scaled value
    std::string note{};                 ///< what limits or ends it otherwise
    bool scaled{};                      ///< a real number carried by an integer
    std::optional<enumeration> names{}; ///< of values or bits
    unsigned first_bit{}, width{};      ///< of a bit-field; of a presence vector the number of bits in use
    std::optional<unsigned> presence{}; ///< bit of the presence vector that announces it
    std::string gate{};                 ///< flag of a structure around it that announces it
    std::string times{};                ///< what counts a list's elements
    std::string selector{};             ///< the member that chooses
    enumeration tags{};                 ///< of a choice's case
    bool has_rows_of_cases{};           ///< a choice whose cases are structures: a variant
    std::vector<part> parts{};
};

/// A message of the reference.
struct message {
    std::uint16_t code{};
    std::string name{};      ///< the standard's
    std::string structure{}; ///< name of its type
    std::size_t least{}, most{};
    unsigned rank{};       ///< its place in the translation tables
    std::string diagram{}; ///< file name, in the pages' folder; empty for a message without a body
    std::vector<part> parts{};
};

} // namespace jauscat::reference
