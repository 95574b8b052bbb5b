#include "decode_message.hpp"

namespace jausdump {

body_decoder find_inform_decoder(std::uint16_t command_code) {
    return find_decoder_between<0x4000, 0x5FFF>(command_code);
}

} // namespace jausdump
