// CoE messages from a mailbox: as a slave answers them, and as a master takes them for an answer.
#include "support/described_objects.hpp"
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/slave/coe_server.hpp>

using namespace fuzz;
using namespace jauscat;
using namespace jauscat::ethercat;

namespace {

// Whether a request asks for a write that a slave without segments and complete access carries out, and of what.
struct wanted_write {
    bool valid{};
    byte_vector data{};
};
wanted_write wanted(std::span<const std::byte> message) {
    coe_header coe{};
    const auto used = wire::decode_prefix(coe, message);
    sdo_normal normal{};
    if (!used || !wire::decode_prefix(normal, message.subspan(*used))) return {};
    const auto& head = normal.header;
    if (coe.service != coe_service::sdo_request || head.specifier != sdo_specifier::download_request ||
        head.complete_access)
        return {};
    const auto data = message.subspan(*used + wire::max_size<sdo_normal>);
    if (head.expedited) {
        const auto four = message.subspan(*used + wire::max_size<sdo_header>, 4);
        return {true, copy_of(four.first(head.size_indicated ? 4u - head.unused : 4u))};
    }
    return {!head.size_indicated || normal.size == data.size(), copy_of(data)};
}

void check_slave(std::span<const std::byte> message, std::size_t room) {
    objects source;
    coe_server server{source};
    byte_vector out(room);
    const auto answer = server.answer(message, out);
    check(answer.size <= out.size(), "an answer fits the mailbox");
    check(answer.size == 0 || answer.error == mailbox_error_code::none, "either an answer or an error");
    if (source.writes != 0) {
        const auto write = wanted(message);
        check(source.writes == 1 && write.valid, "only a complete download request writes");
        check(source.last_written == write.data, "a slave writes what was sent");
    }
    if (answer.size == 0) return;

    const auto reply = std::span<const std::byte>{out}.first(answer.size);
    coe_header coe{};
    sdo_normal sdo{}, request{};
    check(wire::decode_prefix(coe, reply) && wire::decode_prefix(sdo, reply.subspan(2)), "an answer is an SDO message");
    check(coe.service == coe_service::sdo_response ||
              (coe.service == coe_service::sdo_request && sdo.header.specifier == sdo_specifier::abort),
          "an answer is a response or an abort");
    static_cast<void>(wire::decode_prefix(request, message.subspan(2)));
    check(sdo.header.index == request.header.index && sdo.header.subindex == request.header.subindex,
          "an answer names the object that was asked for");

    // A master that asked for this object takes the answer for one.
    byte_vector into(out.size());
    auto transfer = request.header.specifier == sdo_specifier::upload_request
                        ? sdo_transfer::upload(request.header.index, request.header.subindex, into)
                        : sdo_transfer::download(request.header.index, request.header.subindex, {});
    check(transfer.take(reply) == reply_kind::complete, "a master takes a slave's answer");
    const bool aborted = sdo.header.specifier == sdo_specifier::abort;
    check(transfer.result().error().code == (aborted ? master_errc::sdo_abort : master_errc::ok),
          "master and slave agree on how it ended");
    if (!aborted && source.reads != 0)
        check(*transfer.result() == std::size_t{request.header.subindex} * 4, "an object is read whole");
}

// A server that describes its objects: each message of an answer fits, and the answer ends.
void check_information(std::span<const std::byte> message, std::size_t room) {
    described_objects source;
    byte_vector memory(1020);
    coe_server server{source, {.transfer_memory = memory, .subindex_0_rule = true, .state_rule = true}};
    byte_vector out(room);
    auto answer = server.answer(message, out);
    check(answer.size <= out.size(), "an answer fits the mailbox");
    std::size_t fragments = 1;
    for (; server.has_more(); ++fragments) {
        answer = server.next(out);
        check(answer.size != 0 && answer.size <= out.size(), "a fragment fits the mailbox");
        sdo_information_header header{};
        check(wire::decode_prefix(header, std::span{out}.subspan(2)) && header.incomplete == server.has_more(),
              "a fragment says whether another one follows");
    }
    check(fragments <= 10, "an answer about so few objects ends");
}

void check_master(std::span<const std::byte> message, sdo_transfer transfer, std::size_t room) {
    const auto before = transfer.result();
    const auto what = transfer.take(message);
    if (what == reply_kind::unrelated) {
        check(transfer.result() == before, "what is not the answer changes no result");
        return;
    }
    coe_header coe{};
    sdo_header sdo{};
    const bool is_complete = wire::decode_prefix(coe, message) && wire::decode_prefix(sdo, message.subspan(2));
    check(is_complete || transfer.result().error().code == master_errc::sdo_abort,
          "an answer that is no abort is complete");
    check(*transfer.result() <= room, "an upload fits its buffer");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    input_reader in{input};
    const auto room = min_mailbox_size - wire::max_size<mailbox_header> + in.take();
    const byte_vector message = copy_of(in.rest());
    check_slave(message, room);
    check_information(message, room);

    sdo_header asked{}; // for the object that the message is about, so that it may be an answer
    if (message.size() >= 6) static_cast<void>(wire::decode_prefix(asked, std::span{message}.subspan(2)));
    byte_vector into(room);
    check_master(message, sdo_transfer::upload(asked.index, asked.subindex, into), room);
    check_master(message, sdo_transfer::download(asked.index, asked.subindex, into), room);
}
