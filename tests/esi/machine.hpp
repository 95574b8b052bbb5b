// An emulated slave of a description, alone on a link with a master.
#pragma once
#include "support/catch.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/mapped_objects.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace jauscat::test {

/// Stores written data, and returns them. It accepts any data.
class store {
  public:
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        const auto found = values_.find({index, subindex});
        if (found == values_.end()) return {.error = ethercat::abort_code::no_data};
        if (found->second.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        std::ranges::copy(found->second, out.begin());
        return {.size = found->second.size()};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        values_[{index, subindex}].assign(data.begin(), data.end());
        return ethercat::abort_code::none;
    }

  private:
    std::map<std::pair<std::uint16_t, std::uint8_t>, std::vector<std::byte>> values_{};
};

/// The master has brought the slave up.
class machine {
  public:
    using bytes = std::vector<std::byte>;
    static constexpr std::uint16_t station = 0x1001;

    /// The slave has memory for transfers in segments of `transfer_size` bytes.
    machine(const ethercat::slave_description& description, std::span<const bridging::object_description> components,
            std::size_t transfer_size)
        : memory_(transfer_size),
          listed_{components, store_},
          mapped_{description, listed_},
          objects_{description, mapped_},
          slave_{{ethercat::slave{description, objects_, {.transfer_memory = memory_}}}} {
        mapped_.show(slave().outputs(), slave().inputs());
        REQUIRE(run(ethercat::bring_up{0, station}));
    }
    machine(const machine&) = delete;
    machine& operator=(const machine&) = delete;

    [[nodiscard]] ethercat::slave& slave() { return slave_[0]; }
    [[nodiscard]] const ethercat::slave_record& record() { return *master_.find(station); }
    template <ethercat::master_job Job> typename Job::result_type run(const Job& job) {
        return net::run(link_, master_, job);
    }

    /// How a transfer ended, and the data of an upload.
    struct answer {
        ethercat::master_error error{};
        bytes data{};
        friend bool operator==(const answer&, const answer&) = default;
    };

    answer upload(std::uint16_t index, std::uint8_t subindex) {
        bytes data(2000);
        const auto result = run(ethercat::upload{station, index, subindex, data});
        data.resize(result ? result->size() : 0);
        return {result.error(), data};
    }
    answer download(std::uint16_t index, std::uint8_t subindex, std::size_t size) {
        const bytes data(size, std::byte{0x5A});
        return {run(ethercat::download{station, index, subindex, data}).error(), {}};
    }

    /// What a master reads from `address` on.
    bytes read(std::uint16_t address, std::size_t size) {
        bytes data(size);
        CHECK(run(ethercat::exchange_datagram{ethercat::command::fprd, station, address, data}) == 1);
        return data;
    }
    void write(std::uint16_t address, bytes data) {
        REQUIRE(run(ethercat::exchange_datagram{ethercat::command::fpwr, station, address, data}) == 1);
    }
    /// What a master reads of the SII, 4 bytes at a time.
    bytes read_sii(std::size_t size = ethercat::sii_image{}.size()) {
        using namespace ethercat;
        bytes image;
        write(esc_registers::sii_owner.address, {std::byte{2}}); // by force, then without
        write(esc_registers::sii_owner.address, {std::byte{0}});
        for (std::uint32_t word = 0; word != size / 2; word += 2) {
            bytes request(wire::max_size<sii_request>);
            REQUIRE(wire::encode(sii_request{.cmd = sii_command::read, .address = word}, request));
            write(esc_registers::sii_control.address, request);
            const auto data = read(esc_registers::sii_data.address, 4);
            image.insert(image.end(), data.begin(), data.end());
        }
        return image;
    }

    using cycle_data = ethercat::process_data_for<1, 2048>;
    /// One cycle with `outputs`; the inputs it brings.
    bytes exchange(ethercat::process_data& data, const bytes& outputs) {
        std::ranges::copy(outputs, data.outputs(record()).begin());
        bytes frame(ethercat::max_frame_size);
        data.begin_cycle();
        frame.resize(data.next_frame(frame, {}));
        slave().process(frame);
        REQUIRE(data.on_frame(frame));
        CHECK(data.is_complete());
        const auto inputs = data.inputs(record());
        return {inputs.begin(), inputs.end()};
    }
    [[nodiscard]] cycle_data cyclic() { return cycle_data{master_.slaves()}; }

  private:
    bytes memory_;
    store store_{};
    bridging::listed_objects listed_;
    ethercat::mapped_objects mapped_;
    ethercat::standard_objects objects_;
    std::array<ethercat::slave, 1> slave_;
    ethercat::loopback_link link_{slave_};
    ethercat::master_for<16> master_{};
};

} // namespace jauscat::test
