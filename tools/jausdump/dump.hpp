// From received bytes to what is printed: takes messages apart, puts large data sets together, counts.
#pragma once
#include "decoder.hpp"
#include "filter.hpp"
#include "object_table.hpp"
#include "printer.hpp"
#include "sae_messages.hpp"
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/sae/transport/jserial.hpp>

namespace jausdump {

enum class format { text_lines, json_lines };

/// The options of the command line.
struct options {
    jausdump::format format{};
    jausdump::translation translation{};
    jausdump::filter filter{};
    bool sae{};              ///< lines are payloads of SAE JAUS
    bool sae_mobility_1_0{}; ///< peers speak mobility services of version 1.0
    bool reencode{};
    bool hex{};          ///< bytes with offsets, in text
    bool summary_only{}; ///< print no messages
    bool quiet{};        ///< print no messages and no summary
    time_display time{};
    palette colours{};
    std::vector<jaus::payload_type> payload_types{};
    std::function<void(const record&)> receiver{}; ///< of each message; not set: it is printed
    std::function<void()> on_message{};            ///< before each message that passes the filter
    std::function<void()> on_skipped{};            ///< for each packet that is counted as skipped
    std::function<void(const record&)> watcher{};  ///< also gets each message
};

class dump {
  public:
    explicit dump(options how);

    /// A line of hex digits: one message, or with `sae` one payload, decoded on its own with any flags.
    void on_line(const std::string& line, std::size_t number);
    /// A UDP payload: messages of the RA or of SAE JAUS, a packet of a large data set, or something else.
    void on_datagram(std::span<const std::byte> payload, const origin& from);
    /// A message of SAE JAUS of a TCP stream. `part`: its bytes, also where its end is unknown.
    void on_sae_message(const sae::split_transport_message& message, std::span<const std::byte> part,
                        const origin& from) {
        sae_.on_message(message, part, from);
    }
    /// A frame of a serial line.
    void on_serial_frame(const sae::serial_frame& frame, const origin& from);
    /// Messages of SAE JAUS, one behind the other.
    void on_sae_messages(std::span<const std::byte> bytes, const origin& from) { sae_.on_messages(bytes, from); }
    /// A message of the RA that an object of an EtherCAT slave stood for.
    void on_object(std::span<const std::byte> bytes, const origin& from);
    /// The data of a component's object that are no message.
    void on_unreadable_object(std::span<const std::byte> data, jauscat::translate::errc error, const origin& from);
    /// A message, by its header and code alone, that a slave refused or did not give.
    void on_refused(record message);
    void on_lost_transfer() { summary_.lose_transfer(); }
    void on_skipped(const std::string& reason) {
        summary_.skip(reason);
        if (options_.on_skipped) options_.on_skipped();
    }

    [[nodiscard]] bool has_seen_anything() const { return !summary_.empty(); }
    /// Prints what is left to say. Returns whether everything was decoded.
    bool finish();

  private:
    /// All messages of a datagram or of a line.
    void take_datagram(std::span<const std::byte> datagram, const record& as, bool network);
    void take_apart(record& message, bool network);
    void decode(record& message, bool network);
    void add_packet_of_data_set(record& message);
    void tell(const record& message);

    options options_;
    payload_directory payloads_;
    summary summary_{};
    time_stamps time_stamps_{options_.time};
    bool heading_printed_{};
    sae_messages sae_{{.text = options_.format == format::text_lines,
                       .reencode = options_.reencode,
                       .mobility_1_0 = options_.sae_mobility_1_0},
                      [this](const record& message) { tell(message); },
                      [this] { summary_.lose_data_set(); }};

    // 16 data sets of at most 1 MiB and 4096 packets; one that is silent for 10 seconds gives its place to another.
    std::vector<jaus::partial_data_set> places_ = std::vector<jaus::partial_data_set>(16);
    std::vector<jaus::held_packet> packets_ = std::vector<jaus::held_packet>(16 * 4096);
    std::vector<std::byte> memory_ = std::vector<std::byte>(std::size_t{16} << 20);
    // A capture may consist of parts, or be typed in: only its content counts, not its timing.
    jaus::reassembler data_sets_{
        places_, packets_, memory_, std::chrono::seconds{10}, {.longest_gap = std::chrono::seconds{10}}};
};

} // namespace jausdump
