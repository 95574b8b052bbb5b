// The SII memory of a slave: read by position, decoded.
#pragma once
#include "ecat/ring.hpp"
#include <jauscat/schema/ethercat/sii.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ecat {

/// Reads the memory while it lives, and returns it to the slave's application if that had it. An access that is in
/// progress is waited for. Throws `failure` if the memory is in use or cannot be read.
class sii_reader {
  public:
    sii_reader(ring& on, std::uint16_t position);
    ~sii_reader();
    sii_reader(const sii_reader&) = delete;
    sii_reader& operator=(const sii_reader&) = delete;

    /// From a word address on.
    [[nodiscard]] bytes read(std::uint32_t word, std::size_t size);
    template <class T> [[nodiscard]] T read(std::uint32_t word) {
        return decoded<T>(read(word, jauscat::wire::max_size<T>));
    }
    /// Called after each access.
    std::function<void()> on_access{};

  private:
    void fetch(std::uint32_t word);
    ethercat::sii_access wait_until_ready();

    ring& ring_;
    std::uint16_t position_;
    bool was_applications_{};
    std::map<std::uint32_t, std::array<std::byte, 2>> words_{};
};

/// A category as it stands in the memory.
struct sii_part {
    ethercat::sii_category category{};
    std::uint32_t word{}; ///< of its data
    bytes data{};
};

struct sii_pdo_description {
    ethercat::sii_pdo pdo{};
    bool is_output{};
    std::string name{};
    struct entry {
        ethercat::sii_pdo_entry is{};
        std::string name{};
    };
    std::vector<entry> entries{};
};

/// The decoded memory. Categories that are not complete are left out and named in `problems`.
struct sii_content {
    ethercat::sii_configuration configuration{};
    bool is_checksum_right{};
    ethercat::sii_identity identity{};
    ethercat::sii_mailbox mailbox{};
    ethercat::sii_size size{};
    std::vector<sii_part> parts{};
    std::vector<std::string> strings{};
    std::optional<ethercat::sii_general> general{};
    std::vector<ethercat::sii_fmmu_use> fmmus{};
    std::vector<ethercat::sii_sync_manager> sync_managers{};
    std::vector<sii_pdo_description> pdos{};
    std::vector<std::string> problems{};

    [[nodiscard]] std::string string(std::size_t number) const; ///< from 1; empty: none
    /// Device name; empty: none.
    [[nodiscard]] std::string name() const { return general ? string(general->name) : std::string{}; }
    /// Bytes of the memory, as it says.
    [[nodiscard]] std::size_t memory_size() const noexcept { return (std::size_t{size.kibit} + 1) * 128; }
    /// Bytes up to the end of the categories.
    std::size_t used{};
};

enum class sii_depth {
    name, ///< identity, and categories up to the device name
    all
};
[[nodiscard]] sii_content read_sii(sii_reader& reader, sii_depth depth);
[[nodiscard]] const char* category_name(ethercat::sii_category category);

} // namespace ecat
