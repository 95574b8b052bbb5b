// Hilscher packets.
#include <jauscat/ethercat/hilscher/impl/packet_emergencies.ipp>
#include <jauscat/ethercat/hilscher/impl/packet_info.ipp>
#include <jauscat/ethercat/hilscher/impl/packet_job.ipp>
#include <jauscat/ethercat/hilscher/impl/packet_scan.ipp>
#include <jauscat/ethercat/hilscher/impl/packet_state.ipp>
#include <jauscat/ethercat/hilscher/impl/packet_transfer.ipp>
