// Description of one device in an ESI file (EtherCAT Slave Information, ETG.2000), as plain values.
#pragma once

#include <jauscat/esi/error.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::esi {

/// Additional property of an object or entry. Tools ignore unknown names.
struct property {
    std::string name{};
    std::string value{};

    friend bool operator==(const property&, const property&) = default;
};

struct entry {
    std::uint8_t subindex{};               ///< 0 to 255
    std::string name{};                    ///< for display
    std::string type{};                    ///< a base type of ETG.1020, such as USINT or OCTET_STRING(28)
    std::uint32_t bit_size{};              ///< of a string: the maximum
    bool readable{};                       ///< a master may read it
    bool writable{};                       ///< a master may write it
    std::vector<std::byte> default_data{}; ///< little-endian; empty: none
    std::vector<property> properties{};    ///< further properties

    friend bool operator==(const entry&, const entry&) = default;
};

/// Object codes of ETG.1000.6.
enum class object_code : std::uint8_t { variable = 7, array = 8, record = 9 };

/// An object of the dictionary. A variable has one entry, subindex 0. In an array and in a record subindex 0 is a
/// USINT, the highest subindex; the others follow in ascending order, in an array all of one type and without gaps.
struct object {
    std::uint16_t index{};              ///< 0000h to FFFFh
    std::string name{};                 ///< for display
    object_code code{};                 ///< variable, array or record
    bool mandatory{};                   ///< category m
    std::vector<entry> entries{};       ///< in ascending order of subindices
    std::vector<property> properties{}; ///< further properties

    friend bool operator==(const object&, const object&) = default;
};

/// SyncManager settings of the device.
struct sync_manager {
    ethercat::sii_sync_manager_use use{};
    std::uint16_t start{};        ///< start address in the slave
    std::uint16_t default_size{}; ///< bytes
    std::uint16_t min_size{};     ///< 0: not stated
    std::uint16_t max_size{};     ///< 0: not stated
    std::uint8_t control{};       ///< 26h mailbox out, 22h mailbox in, 64h outputs, 20h inputs
    bool enabled{};               ///< from the start
    bool is_virtual{};            ///< not switched on: an FMMU alone maps what is at its place, such as registers

    friend bool operator==(const sync_manager&, const sync_manager&) = default;
};

/// An object, or a gap, in a PDO.
struct pdo_entry {
    std::uint16_t index{};   ///< of the mapped object; 0: a gap
    std::uint8_t subindex{}; ///< of a gap: 0
    std::uint16_t bits{};    ///< 1 to 255 in the SII and in the mapping object
    std::string name{};      ///< for display
    std::string type{};      ///< a base type of ETG.1020; empty: not stated; of a gap: none

    friend bool operator==(const pdo_entry&, const pdo_entry&) = default;
};

/// `pdo::sync_manager` of a PDO that is not transferred unless a tool assigns it.
inline constexpr std::uint8_t not_assigned = 0xFF;

/// PDO: process data that are mapped together.
struct pdo {
    std::uint16_t index{};            ///< of its mapping object
    std::string name{};               ///< for display
    std::uint8_t sync_manager{};      ///< its default SyncManager; `not_assigned`: none
    bool fixed{};                     ///< its entries cannot be changed
    bool mandatory{};                 ///< it is always assigned
    std::vector<pdo_entry> entries{}; ///< in wire order

    friend bool operator==(const pdo&, const pdo&) = default;
};

/// CoE features of the device.
struct coe_features {
    bool sdo_information{};   ///< without it, tools use the dictionary of the ESI file
    bool pdo_assign{};        ///< objects 1C12h and 1C13h can be written
    bool pdo_configuration{}; ///< PDO mapping objects can be written
    bool complete_access{};   ///< accepts a whole object in one transfer
    bool segmented_sdo{};     ///< accepts objects larger than its mailbox

    friend bool operator==(const coe_features&, const coe_features&) = default;
};

/// The EEPROM, which holds the SII.
struct eeprom {
    std::uint32_t byte_size{};            ///< of the memory; 0: no Eeprom element
    std::vector<std::byte> config_data{}; ///< SII words 0 to 6, 14 bytes; tools add the checksum
    std::vector<std::byte> bootstrap{};   ///< SII words 14h to 17h, 8 bytes; empty: no state BOOT
    std::vector<std::byte> image{};       ///< the whole SII where the file has it (Data); else empty

    friend bool operator==(const eeprom&, const eeprom&) = default;
};

/// A mode of synchronization by the distributed clock (Dc/OpMode).
struct clock_mode {
    std::string name{};              ///< by which a tool offers it
    std::string description{};       ///< for display; may be empty
    std::uint16_t assign_activate{}; ///< registers 0980h and 0981h; 0: not synchronized by the clock
    std::uint32_t cycle_time_0{};    ///< ns, of SYNC0; 0: `cycle_factor_0` times the cycle of the bus
    std::int32_t shift_time_0{};     ///< ns, of SYNC0
    std::uint32_t cycle_time_1{};    ///< ns, of SYNC1; 0: `cycle_factor_1` times the cycle of SYNC0
    std::int32_t shift_time_1{};     ///< ns, of SYNC1
    std::int16_t cycle_factor_0{};   ///< of SYNC0
    std::int16_t cycle_factor_1{};   ///< of SYNC1

    friend bool operator==(const clock_mode&, const clock_mode&) = default;
};

/// An object that a master writes on the way between two states (InitCmd of CoE).
struct start_up_object {
    std::vector<std::string> transitions{}; ///< PS: from PRE-OP to SAFE-OP
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::vector<std::byte> data{};
    bool complete_access{}; ///< `data` are of the whole object
    std::string comment{};  ///< for display; may be empty

    friend bool operator==(const start_up_object&, const start_up_object&) = default;
};

/// How long a device may take (Info). Nothing: the file does not say.
struct timeouts {
    std::optional<std::chrono::milliseconds> pre_op{};          ///< from INIT
    std::optional<std::chrono::milliseconds> safe_op_op{};      ///< from PRE-OP to SAFE-OP, and from there to OP
    std::optional<std::chrono::milliseconds> back_to_init{};    ///< from any state
    std::optional<std::chrono::milliseconds> back_to_safe_op{}; ///< from OP
    std::optional<std::chrono::milliseconds> request{};         ///< of the mailbox, until the slave has taken it
    std::optional<std::chrono::milliseconds> response{};        ///< of the mailbox, until the answer is there

    friend bool operator==(const timeouts&, const timeouts&) = default;
};

/// A place for modules.
struct slot {
    std::string name{};                         ///< for display; may be empty
    std::uint32_t min_instances{};              ///< so many modules at least
    std::uint32_t max_instances{};              ///< and at most
    std::vector<std::uint32_t> module_idents{}; ///< of the modules that fit
    std::vector<std::string> module_classes{};  ///< classes of the modules that fit

    friend bool operator==(const slot&, const slot&) = default;
};

/// A module of a modular device (Modules/Module).
struct module_description {
    std::uint32_t ident{};      ///< by which slots name it
    std::string module_class{}; ///< by which slots name its class; may be empty
    std::string type{};         ///< short name, such as an order number
    std::string name{};         ///< for display
    std::vector<pdo> rx_pdos{}; ///< master to slave
    std::vector<pdo> tx_pdos{}; ///< slave to master
    std::vector<error> slips{}; ///< what was left out, as in a device

    friend bool operator==(const module_description&, const module_description&) = default;
};

struct device {
    std::uint32_t vendor_id{};                 ///< assigned by the EtherCAT Technology Group
    std::string vendor_name{};                 ///< for display
    std::string group_type{};                  ///< key of the device's group
    std::string group_name{};                  ///< for display
    std::string physics{"YY"};                 ///< a letter for each port: Y 100BASE-TX, K E-bus, space none; or empty
    std::string type{};                        ///< short name, such as an order number
    std::uint32_t product_code{};              ///< object 1018h:2; 0: not stated
    std::uint32_t revision{};                  ///< object 1018h:3; 0: not stated
    std::uint32_t serial{};                    ///< 0: not stated, as in a file for all devices of a type
    std::string name{};                        ///< for display
    std::uint16_t profile{};                   ///< device profile, low word of object 1000h; 0: none
    std::vector<object> objects{};             ///< the dictionary, in ascending order of indices
    std::vector<std::string> fmmus{};          ///< use of each: Outputs, Inputs, MBoxState, DynamicOutputs ...
    std::vector<sync_manager> sync_managers{}; ///< SyncManager 0 first
    std::vector<pdo> rx_pdos{};                ///< master to slave
    std::vector<pdo> tx_pdos{};                ///< slave to master
    bool has_coe{true};                        ///< a mailbox with CoE; else no Mailbox or CoE element
    coe_features coe{};                        ///< all false without CoE
    std::vector<std::string> protocols{};      ///< of the mailbox, besides CoE: AoE, EoE, FoE, SoE, VoE
    std::vector<start_up_object> start_up{};   ///< objects that a master writes, in the file's order
    std::vector<clock_mode> clock_modes{};     ///< the default first; empty: no Dc element
    std::vector<slot> slots{};                 ///< of a modular device
    esi::timeouts timeouts{};                  ///< how long it may take
    esi::eeprom eeprom{};                      ///< EEPROM of the SII
    std::vector<error> slips{};                ///< what could not be read, with its line: that part alone is left out

    friend bool operator==(const device&, const device&) = default;
};

} // namespace jauscat::esi
