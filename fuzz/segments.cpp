// One SDO transfer in segments between our master and our slave, over a way that changes messages as the input says.
#include "support/target.hpp"
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/slave/coe_server.hpp>

using namespace fuzz;
using namespace jauscat;
using namespace jauscat::ethercat;

namespace {

/// Every object is the same one, and takes any size.
struct object {
    byte_vector value{};
    std::size_t writes{};

    object_read read(std::uint16_t, std::uint8_t, std::span<std::byte> out) noexcept {
        if (value.size() > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::copy(value, out.begin());
        return {.size = value.size()};
    }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte> data) noexcept {
        value = copy_of(data);
        ++writes;
        return abort_code::none;
    }
};

class session {
  public:
    explicit session(std::span<const std::byte> input) : in_{input} {}

    void run() {
        const std::size_t out_room = room(), in_room = room();
        const auto options = in_.take();
        const byte_vector data = counting(in_.take<wire::u16le>() % 600u);
        const bool uploads = (options & 1) != 0, cleared = (options & 2) != 0, ruled = (options & 4) != 0;
        object source;
        byte_vector memory((options & 32) != 0 ? data.size() / 2 : data.size()), into(data.size());
        if (uploads) source.value = data;
        coe_server server{source,
                          {.transfer_memory = memory, .subindex_0_rule = ruled, .empty_start = (options & 8) != 0}};
        auto transfer = uploads
                            ? sdo_transfer::upload(0x1AF5, 26, into)
                            : sdo_transfer::download(0x1AF5, 26, data,
                                                     {.clear_subindex_0 = cleared, .empty_start = (options & 16) != 0});
        transfer.use_mailbox(out_room + wire::max_size<mailbox_header>);

        auto what = reply_kind::proceed;
        for (std::size_t messages = 0; what == reply_kind::proceed; ++messages) {
            check(messages <= data.size() + 2, "a transfer comes to an end");
            byte_vector request(transfer.size());
            check(request.size() <= out_room, "a request fits the mailbox");
            transfer.encode(request);
            change(request, out_room);
            byte_vector reply(in_room, std::byte{0xEE});
            const auto answer = server.answer(request, reply);
            check(answer.size <= reply.size(), "an answer fits the mailbox");
            reply.resize(answer.size);
            change(reply, in_room);
            what = transfer.take(reply);
        }

        const auto& result = transfer.result();
        check((what == reply_kind::complete) == transfer.finished(), "a transfer knows whether it is finished");
        check(*result <= into.size(), "an upload fits its buffer");
        if (!clean_) return;
        check(what == reply_kind::complete, "a clean transfer is answered");
        const auto first_room = (uploads ? in_room : out_room) - 10;
        const bool too_large = data.size() > std::max(memory.size(), first_room);
        const bool refused = too_large || (ruled && !cleared && !uploads);
        check(static_cast<bool>(result) != refused, "a clean transfer succeeds unless the slave cannot take it");
        check(result || !transfer.is_open(), "an aborted transfer is not open");
        if (!result) return;
        if (uploads) check(into == data && *result == data.size(), "an upload gives the object");
        if (!uploads) check(source.value == data, "a download writes the data");
        if (!uploads) check(source.writes == (cleared && !ruled ? 2u : 1u), "a download writes once");
    }

  private:
    // Bytes of a message in a mailbox of 24 to 87.
    std::size_t room() { return min_mailbox_size - wire::max_size<mailbox_header> + in_.take() % 64; }

    static byte_vector counting(std::size_t size) {
        byte_vector data(size);
        for (std::size_t i = 0; i != size; ++i) data[i] = static_cast<std::byte>(i);
        return data;
    }

    void change(byte_vector& message, std::size_t room) {
        const auto fate = in_.take() % 8;
        if (fate < 5 || message.empty()) return;
        clean_ = false;
        if (fate == 5) message.resize(in_.take() % room);
        for (auto left = fate == 6 ? 1 : in_.take() % 8; left != 0 && !message.empty(); --left)
            message[in_.take() % message.size()] = std::byte{in_.take()};
    }

    input_reader in_;
    bool clean_{true};
};

} // namespace

void fuzz::run(std::span<const std::byte> input) { session{input}.run(); }
