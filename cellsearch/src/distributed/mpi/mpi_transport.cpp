// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/distributed/mpi_transport.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "distributed/reduce.hpp"
#include "mpi_connection.hpp"

namespace cellsearch {

namespace {

constexpr int gather_tag = 0;

class MpiExchange final : public Exchange {
 public:
  MpiExchange(MpiConnection& connection, int channel, Traffic& traffic)
      : connection_(connection), channel_(channel), traffic_(traffic) {}

  /// A round that a fault has cut off leaves receives behind; their buffers may end now.
  ~MpiExchange() override {
    for (MPI_Request& request : arriving_) {
      if (request == MPI_REQUEST_NULL) continue;
      MPI_Cancel(&request);
      MPI_Request_free(&request);
    }
  }

  void start(std::span<const Outgoing> sends, std::span<Incoming> receives) override {
    if (under_way_) throw std::logic_error("The last round of this exchange is not finished.");
    under_way_ = true;
    receives_ = receives;
    arriving_.assign(receives.size(), MPI_REQUEST_NULL);
    growing_.clear();
    for (std::size_t slot = 0; slot < receives.size(); ++slot) {
      const Incoming& expected = receives[slot];
      if (expected.grown != nullptr) {
        growing_.push_back(static_cast<int>(slot));
      } else {
        connection_.check(MPI_Irecv(expected.buffer.data(), mpi_count(expected.buffer.size()), MPI_BYTE,
                                    expected.from, channel_, connection_.messages, &arriving_[slot]));
      }
    }
    leaving_.assign(sends.size(), MPI_REQUEST_NULL);
    for (std::size_t slot = 0; slot < sends.size(); ++slot) {
      const Outgoing& message = sends[slot];
      connection_.check(MPI_Isend(message.bytes.data(), mpi_count(message.bytes.size()), MPI_BYTE, message.to,
                                  channel_, connection_.messages, &leaving_[slot]));
      ++traffic_.messages;
      traffic_.bytes += static_cast<Offset>(message.bytes.size());
    }
  }

  int finish_next() override {
    for (unsigned turn = 0;; ++turn) {
      int slot = MPI_UNDEFINED;
      int there = 0;
      MPI_Status status;
      connection_.check(
          MPI_Testany(static_cast<int>(arriving_.size()), arriving_.data(), &slot, &there, &status));
      if (there != 0 && slot != MPI_UNDEFINED) {
        receives_[static_cast<std::size_t>(slot)].received = length_of(status);
        return slot;
      }
      const int grown = receive_grown();
      if (grown >= 0) return grown;
      // True without a slot: none of known length is left.
      if (there != 0 && growing_.empty()) break;
      connection_.watch(turn);
    }
    connection_.wait_all(leaving_);
    under_way_ = false;
    return -1;
  }

 private:
  static std::size_t length_of(const MPI_Status& status) {
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    return static_cast<std::size_t>(count);
  }

  /// Takes one message of unknown length, if there is one; -1 if not.
  int receive_grown() {
    for (std::size_t place = 0; place < growing_.size(); ++place) {
      Incoming& expected = receives_[static_cast<std::size_t>(growing_[place])];
      int there = 0;
      MPI_Message message = MPI_MESSAGE_NULL;
      MPI_Status status;
      connection_.check(
          MPI_Improbe(expected.from, channel_, connection_.messages, &there, &message, &status));
      if (there == 0) continue;
      expected.received = length_of(status);
      expected.grown->resize(expected.received);
      connection_.check(
          MPI_Mrecv(expected.grown->data(), mpi_count(expected.received), MPI_BYTE, &message, &status));
      const int slot = growing_[place];
      growing_[place] = growing_.back();
      growing_.pop_back();
      return slot;
    }
    return -1;
  }

  MpiConnection& connection_;
  int channel_;
  Traffic& traffic_;
  std::span<Incoming> receives_;
  std::vector<MPI_Request> arriving_;
  std::vector<MPI_Request> leaving_;
  std::vector<int> growing_;  // slots of unknown length that are still expected
  bool under_way_ = false;
};

/// Lengths to places; the sum.
std::size_t add_up(const std::vector<std::int64_t>& lengths, Array<Offset>& first) {
  first.resize(lengths.size() + 1);
  first[0] = 0;
  std::partial_sum(lengths.begin(), lengths.end(), first.begin() + 1);
  return static_cast<std::size_t>(first.back());
}

}  // namespace

MpiTransport::MpiTransport(MPI_Comm communicator)
    : connection_(std::make_unique<MpiConnection>(communicator)) {}

MpiTransport::~MpiTransport() = default;

int MpiTransport::rank() const noexcept {
  return connection_->rank;
}

int MpiTransport::size() const noexcept {
  return connection_->size;
}

std::unique_ptr<Exchange> MpiTransport::open_exchange() {
  // Every MPI has at least 32768 tags.
  if (connection_->channels > 32767) throw std::length_error("There are more than 32767 exchanges.");
  return std::make_unique<MpiExchange>(*connection_, connection_->channels++, traffic_);
}

void MpiTransport::start_allreduce(Reduction how, std::span<double> values) {
  MpiConnection& own = *connection_;
  const int count = mpi_count(values.size());
  ++traffic_.reductions;
  if (how == Reduction::Sum) {
    own.sum = values;
    own.terms.resize(values.size() * static_cast<std::size_t>(own.size));
    own.check(MPI_Iallgather(values.data(), count, MPI_DOUBLE, own.terms.data(), count, MPI_DOUBLE,
                             own.messages, &own.reduction));
    return;
  }
  join(how, values.data(), values.data(), values.size());  // every NaN becomes the same
  own.check(MPI_Iallreduce(MPI_IN_PLACE, values.data(), count, MPI_DOUBLE,
                           how == Reduction::Min ? own.minimum : own.maximum, own.messages, &own.reduction));
}

void MpiTransport::start_allreduce(Reduction how, std::span<std::int64_t> values) {
  ++traffic_.reductions;
  MPI_Op operation = MPI_SUM;
  if (how == Reduction::Min) operation = MPI_MIN;
  if (how == Reduction::Max) operation = MPI_MAX;
  connection_->check(MPI_Iallreduce(MPI_IN_PLACE, values.data(), mpi_count(values.size()), MPI_INT64_T,
                                    operation, connection_->messages, &connection_->reduction));
}

void MpiTransport::finish_allreduce() {
  MpiConnection& own = *connection_;
  own.wait(own.reduction);
  if (own.sum.empty()) return;
  const std::size_t count = own.sum.size();
  std::copy_n(own.terms.begin(), count, own.sum.begin());
  for (int rank = 1; rank < own.size; ++rank) {
    join(Reduction::Sum, own.terms.data() + static_cast<std::size_t>(rank) * count, own.sum.data(), count);
  }
  own.sum = {};
}

void MpiTransport::allgather(std::span<const std::byte> own, Gathered& all) {
  MpiConnection& connection = *connection_;
  const auto ranks = static_cast<std::size_t>(connection.size);
  const std::int64_t length = mpi_count(own.size());
  connection.lengths.resize(ranks);
  MPI_Request request = MPI_REQUEST_NULL;
  connection.check(MPI_Iallgather(&length, 1, MPI_INT64_T, connection.lengths.data(), 1, MPI_INT64_T,
                                  connection.messages, &request));
  connection.wait(request);
  const std::size_t sum = add_up(connection.lengths, all.first);
  mpi_count(sum);
  all.bytes.resize(sum);
  connection.counts.assign(connection.lengths.begin(), connection.lengths.end());
  connection.places.assign(all.first.begin(), all.first.end() - 1);
  connection.check(MPI_Iallgatherv(own.data(), static_cast<int>(length), MPI_BYTE, all.bytes.data(),
                                   connection.counts.data(), connection.places.data(), MPI_BYTE,
                                   connection.messages, &request));
  connection.wait(request);
  ++traffic_.gathers;
  traffic_.bytes_given += length;
  traffic_.bytes_gathered += static_cast<Offset>(sum);
}

// Message by message: together they may be longer than MPI can count.
void MpiTransport::gather(int root, std::span<const std::byte> own, Gathered& all) {
  MpiConnection& connection = *connection_;
  const std::int64_t length = mpi_count(own.size());
  connection.lengths.assign(connection.rank == root ? static_cast<std::size_t>(connection.size) : 0, 0);
  MPI_Request request = MPI_REQUEST_NULL;
  connection.check(MPI_Igather(&length, 1, MPI_INT64_T, connection.lengths.data(), 1, MPI_INT64_T, root,
                               connection.messages, &request));
  connection.wait(request);
  ++traffic_.gathers;
  traffic_.bytes_given += length;
  all.bytes.clear();
  all.first.clear();
  connection.requests.clear();
  if (connection.rank == root) {
    all.bytes.resize(add_up(connection.lengths, all.first));
    traffic_.bytes_gathered += all.first.back();
    for (int from = 0; from < connection.size; ++from) {
      const auto at = static_cast<std::size_t>(from);
      connection.requests.push_back(MPI_REQUEST_NULL);
      connection.check(MPI_Irecv(all.bytes.data() + all.first[at], static_cast<int>(connection.lengths[at]),
                                 MPI_BYTE, from, gather_tag, connection.messages,
                                 &connection.requests.back()));
    }
  }
  connection.requests.push_back(MPI_REQUEST_NULL);
  connection.check(MPI_Isend(own.data(), static_cast<int>(length), MPI_BYTE, root, gather_tag,
                             connection.messages, &connection.requests.back()));
  connection.wait_all(connection.requests);
}

void MpiTransport::barrier() {
  MPI_Request request = MPI_REQUEST_NULL;
  connection_->check(MPI_Ibarrier(connection_->messages, &request));
  connection_->wait(request);
  ++traffic_.reductions;
}

void MpiTransport::fault(std::string_view message) noexcept {
  connection_->report_fault(message);
}

}  // namespace cellsearch
