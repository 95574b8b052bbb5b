// CoE with one slave: objects read, written and described through its mailbox, by position.
#pragma once
#include "ecat/ring.hpp"
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ecat {

/// A request through the mailbox that has failed.
struct coe_failure : failure {
    coe_failure(const std::string& what, const ethercat::master_error& why) : failure{what}, error{why} {}
    ethercat::master_error error;
};
/// `0x06020000: no such object in the dictionary`, or another reason.
[[nodiscard]] std::string reason_text(const ethercat::master_error& error);

struct object_text {
    ethercat::object_answer is{};
    std::string name{};
};
struct entry_text {
    ethercat::entry_answer is{};
    bytes minimum{}; ///< empty: none
    bytes maximum{};
    std::string name{};
};

/// Sets SyncManagers 0 and 1 of a slave in INIT up for its standard mailbox.
void set_up_mailbox(ring& on, std::uint16_t position, const ethercat::sii_mailbox& mailbox);

/// The mailbox of one slave. A slave in INIT is in PRE-OP while this lives, and in INIT as before afterwards; in other
/// states the mailbox is used as it is set up. Throws `failure` if the slave has no CoE or its state does not permit
/// it.
class coe_mailbox {
  public:
    coe_mailbox(ring& on, std::uint16_t position);
    ~coe_mailbox();
    coe_mailbox(const coe_mailbox&) = delete;
    coe_mailbox& operator=(const coe_mailbox&) = delete;

    // They throw `coe_failure`.
    [[nodiscard]] bytes upload(std::uint16_t index, std::uint8_t subindex);
    void download(std::uint16_t index, std::uint8_t subindex, const bytes& data);
    [[nodiscard]] std::vector<std::uint16_t> objects();
    [[nodiscard]] object_text describe(std::uint16_t index);
    /// With the values that `entry_query` names.
    [[nodiscard]] entry_text describe(std::uint16_t index, std::uint8_t subindex);
    /// The same; none where the slave does not describe it. An object of one entry that has no name gives it its own.
    [[nodiscard]] std::optional<entry_text> try_describe(std::uint16_t index, std::uint8_t subindex);
    /// A number of up to 8 bytes; none where the slave has no such entry.
    [[nodiscard]] std::optional<std::uint64_t> try_number(std::uint16_t index, std::uint8_t subindex);

  private:
    struct state;
    std::unique_ptr<state> is_;
};

/// Whether its SII says that it has a CoE mailbox.
[[nodiscard]] bool has_coe(ring& on, std::uint16_t position);

} // namespace ecat
