// Judges the object dictionary of a slave and the packets that create it: what it says, takes and refuses, by lists of
// objects that the seed makes.
#pragma once

#include "simulation/world.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/bridge/object_creation.hpp>

#include <string>
#include <vector>

namespace simulation {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;

class dictionary_judge final : public actor {
  public:
    explicit dictionary_judge(world& w);
    void start();
    void on_event(std::uint8_t what, std::uint32_t argument) override;

    // The application of the slave, for listed_objects.
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept;
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept;

  private:
    [[nodiscard]] const bridging::object_description* known(std::uint16_t index) const;
    [[nodiscard]] static const bridging::sub_object* entry_of(const bridging::object_description& object,
                                                              std::uint8_t subindex);
    [[nodiscard]] std::uint16_t some_index();
    void look(bridging::listed_objects& at, bool is_exact);
    void look_at_read(bridging::listed_objects& at, bool is_exact, std::uint16_t index, std::uint8_t subindex);
    void look_at_write(bridging::listed_objects& at, bool is_exact, std::uint16_t index, std::uint8_t subindex);
    void look_at_descriptions(const bridging::listed_objects& at, bool is_exact, std::uint16_t index,
                              std::uint8_t subindex);
    void create();
    void look_at_request(const bridging::object_description& object, std::size_t number,
                         std::span<const std::byte> packet, const jauscat::hilscher::packet_header& given);
    void answer(const bridging::object_creation& creation, const bridging::object_description& object,
                std::size_t number, std::uint32_t id);
    void says(bool is_right, const char* expected, std::uint64_t found);

    world& world_;
    std::uint8_t number_;
    generator random_;
    std::vector<std::vector<bridging::sub_object>> entries_{};
    std::vector<bridging::object_description> objects_{};
    bridging::listed_objects up_to_largest_, exact_;
    // What the application is asked for, and what it says.
    bool was_asked_{};
    ethercat::abort_code refuses_{};
    std::size_t size_{};
};

} // namespace simulation
