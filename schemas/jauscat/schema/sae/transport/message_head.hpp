// What is in front of the fields of a message that is no part of a larger one: transport header and message ID.
#pragma once
#include <jauscat/schema/sae/transport/header.hpp>

// clang-format off
namespace jauscat::sae {

/// 14 bytes. The fields of the message follow, then the sequence number.
struct message_head {
    transport_header transport{};
    std::uint16_t message_id{};
    friend constexpr bool operator==(const message_head&, const message_head&) = default;

    struct schema : wire::items {
        using T = message_head;
        using type = layout<
            nested<&T::transport>,
            field<&T::message_id, u16le>>;
    };
};

} // namespace jauscat::sae
