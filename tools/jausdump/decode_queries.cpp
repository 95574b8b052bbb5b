#include "decode_message.hpp"

namespace jausdump {

body_decoder find_query_decoder(std::uint16_t command_code) {
    return find_decoder_between<0x2000, 0x3FFF>(command_code);
}

} // namespace jausdump
