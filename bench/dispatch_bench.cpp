// The dispatcher with a handler for every message against a switch over all codes, and against a hash map of functions.
#include "hand_written_dispatch.hpp"
#include "pair.hpp"
#include <jauscat/jaus/component/dispatcher.hpp>

#include <array>
#include <random>
#include <unordered_map>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;

using bytes = std::vector<std::byte>;

std::array<std::byte, 65536> memory;
wire::arena lists{memory};
std::uint16_t last_handled; // what a handler leaves behind, so that the three ways can be compared

// What every handler does with its message.
struct taker {
    template <class Message> void operator()(const jaus::header& head, const Message& message) const {
        benchmark::DoNotOptimize(&head);
        benchmark::DoNotOptimize(&message);
        last_handled = jaus::command_code_of<Message>;
    }
};
constexpr taker take{};

template <class... Messages> constexpr auto dispatcher_of(jaus::message_list<Messages...>) {
    return jaus::dispatcher{jaus::on<Messages>(take)...};
}

// The work of the dispatcher, by hand: decode what the code says, hand it over.
template <class Message> bool decode_and_take(const jaus::header& head, std::span<const std::byte> body) {
    Message message{};
    if constexpr (wire::needs_memory<Message>) {
        lists.reset();
        if (!wire::decode(message, body, lists)) return false;
    } else {
        if (!wire::decode(message, body)) return false;
    }
    take(head, message);
    return true;
}
using function = bool (*)(const jaus::header&, std::span<const std::byte>);
template <class... Messages> std::unordered_map<std::uint16_t, function> map_of(jaus::message_list<Messages...>) {
    return {{jaus::command_code_of<Messages>, &decode_and_take<Messages>}...};
}

jaus::header head_of(const bytes& message) {
    jaus::header head{};
    static_cast<void>(wire::decode_prefix(head, message)); // made here
    return head;
}
std::span<const std::byte> body_of(const bytes& message) { return std::span{message}.subspan(jaus::header_size); }

[[gnu::noinline]] bool by_dispatcher(const bytes& message) {
    static constinit auto handlers = dispatcher_of(jaus::messages{});
    return handlers(head_of(message), body_of(message), lists) == jaus::dispatched::handled;
}
[[gnu::noinline]] bool by_switch(const bytes& message) {
    const jaus::header head = head_of(message);
    return hand_written::dispatch(head.command_code,
                                  [&]<class Message>() { return decode_and_take<Message>(head, body_of(message)); });
}
// Neither these nor the dispatcher are initialised at the first call, which would be a check in each.
const auto functions_by_code = map_of(jaus::messages{});
[[gnu::noinline]] bool by_map(const bytes& message) {
    const jaus::header head = head_of(message);
    const auto found = functions_by_code.find(head.command_code);
    return found != functions_by_code.end() && found->second(head, body_of(message));
}

// Functions behind the look-up that the dispatcher has, instead of a jump.
template <class... Messages> bool by_look_up(const bytes& message, jaus::message_list<Messages...>) {
    static constexpr std::array codes{jaus::command_code_of<Messages>...};
    static constexpr std::array<function, sizeof...(Messages)> functions{&decode_and_take<Messages>...};
    const jaus::header head = head_of(message);
    const auto place = wire::code_index<codes>::find(head.command_code);
    return place < functions.size() && functions[place](head, body_of(message));
}
[[gnu::noinline]] bool by_look_up(const bytes& message) { return by_look_up(message, jaus::messages{}); }

// Every message once with all it need not have left out, where that makes a message of at most `largest` bytes.
template <class... Messages>
std::vector<bytes> smallest_messages(jaus::message_list<Messages...>, std::size_t largest) {
    std::vector<bytes> all;
    const auto add = [&]<class Message>() {
        bytes made(jaus::header_size + 4096);
        const auto message_bytes =
            jaus::make_message({.destination = {1, 2, 3, 4}, .source = {5, 6, 7, 8}}, Message{}, made);
        if (!message_bytes || message_bytes->size() > largest) return;
        made.resize(message_bytes->size());
        if (by_switch(made)) all.push_back(std::move(made)); // some are not complete without a list
    };
    (add.template operator()<Messages>(), ...);
    return all;
}

void add(const std::vector<bytes>& distinct, std::size_t count, std::vector<bytes>& messages) {
    std::mt19937 random{11};
    for (std::size_t i = 0; i != count; ++i) messages.push_back(distinct[random() % distinct.size()]);
    const std::string label =
        "dispatch, " + std::to_string(distinct.size()) + " messages, " + std::to_string(count) + " in turn";
    bench::pair(label + " (switch)", std::span{messages}, by_dispatcher, std::span{messages}, by_switch);
    bench::pair(label + " (map)", std::span{messages}, by_dispatcher, std::span{messages}, by_map);
    bench::pair(label + " (500-byte look-up)", std::span{messages}, by_dispatcher, std::span{messages},
                static_cast<bool (*)(const bytes&)>(by_look_up));
}

} // namespace

bool bench::add_dispatch_benchmarks() {
    static std::vector<bytes> few, some, many;
    const auto distinct = smallest_messages(jaus::messages{}, jaus::header_size + 4096);
    bool agree = distinct.size() > 50;
    for (const auto& message : distinct)
        for (const auto way : {by_dispatcher, by_switch, by_map, static_cast<bool (*)(const bytes&)>(by_look_up)}) {
            last_handled = 0;
            agree = agree && way(message) && last_handled == head_of(message).command_code;
        }
    // A processor that predicts jumps knows a short sequence by heart, and a long one not at all.
    add(distinct, 64, few);
    add(distinct, 1024, some);
    add(distinct, 65536, many);
    return agree;
}
