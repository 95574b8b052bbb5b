// Decodes messages of SAE JAUS, and puts those of several packets together.
#pragma once
#include "record.hpp"
#include "sae_name.hpp"
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/sae/transport/fragments.hpp>

#include <functional>
#include <memory>

namespace jausdump {

/// What is made of each message.
struct sae_options {
    bool text{}; ///< text, else JSON
    bool reencode{};
    bool mobility_1_0{}; ///< mobility services of version 1.0, else 1.1
};

class sae_messages {
  public:
    /// `tell` gets each message, `lost` is called for each message of several packets that stays incomplete.
    sae_messages(sae_options how, std::function<void(const record&)> tell, std::function<void()> lost);
    ~sae_messages();
    sae_messages(const sae_messages&) = delete;
    sae_messages& operator=(const sae_messages&) = delete;

    /// A payload, from its message ID on.
    void on_payload(std::span<const std::byte> payload, const origin& from);
    /// A message of the transport. `part`: its bytes, also where its end is unknown.
    void on_message(const sae::split_transport_message& message, std::span<const std::byte> part, const origin& from);
    /// The messages of a datagram, behind its version byte.
    void on_messages(std::span<const std::byte> part, const origin& from);
    /// The input has ended.
    void finish();

    /// The name of a message; "unknown" where no set has the ID.
    [[nodiscard]] std::string name_of(std::optional<std::uint16_t> message_id) const;

  private:
    struct fragments;

    void identify(record& message) const;
    void decode(record& message) const;
    void add_packet(record& message);

    sae_options how_;
    jauscat::catalogue::list messages_;
    std::function<void(const record&)> tell_;
    std::function<void()> lost_;
    std::unique_ptr<fragments> fragments_; ///< made for the first packet of several
};

} // namespace jausdump
