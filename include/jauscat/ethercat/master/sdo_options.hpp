// Options of SDO transfers, for differences between slaves.
#pragma once

#include <cstddef>
#include <optional>

namespace jauscat::ethercat {

struct download_options {
    /// First writes 0 (one byte) to subindex 0 of the same index. Slaves that keep the rules of PDO mapping and PDO
    /// assignment objects (1600h to 17FFh, 1A00h to 1BFFh, 1C10h to 1C2Fh) abort a write to their other subindices with
    /// 06010003h until that is done; the seed table's indices, from 6900 (1AF4h) on, lie there. Subindex 0 stays 0
    /// afterwards. Costs one exchange, two frames. A refusal ends the download with master_errc::clear_refused.
    bool clear_subindex_0{};
    /// Starts a download that needs segments without data in its first message. By default that message is filled, as
    /// the standard has it; some slaves (KickCAT's) take data from segments only and would store them shifted.
    bool empty_start{};
    /// The data are all entries of the object, one after the other, from the subindex on, which is 0 or 1. From 0 on,
    /// subindex 0 takes 2 bytes. Not with `clear_subindex_0`.
    bool complete_access{};
};

struct upload_options {
    /// All entries of the object, as in a download.
    bool complete_access{};
    /// Bytes of the entry where something else says how many, such as SDO information (`describe_entry`) or an
    /// ESI file: an answer of another size ends with master_errc::size_mismatch.
    std::optional<std::size_t> size{};
};

} // namespace jauscat::ethercat
