package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Packetizer;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.InMemoryPort;

class VideoFaultsTest {

  private static final InetSocketAddress OPERATOR = address("127.0.0.1", 11111);

  private static final byte[] SEQUENCE = {0, 0, 0, 1, 0x67, 1, 2};
  private static final byte[] PICTURE = {0, 0, 0, 1, 0x68, 1, 2};
  private static final byte[] SLICE = {0, 0, 0, 1, 0x65, 1, 2};

  private final InMemoryPort port = new InMemoryPort(address("127.0.0.1", 62512));
  private final VideoFaults faults = new VideoFaults(1);

  @Test
  void withoutFaultsEverythingIsSentAtOnce() {
    assertThat(packets()).containsExactly(SEQUENCE, PICTURE, SLICE);
    send(100);

    assertThat(port.takeSent()).hasSize(100);
  }

  @Test
  void aShareOfTheDatagramsIsLost() {
    act("video-loss 20%");
    send(1000);

    assertThat(port.takeSent()).hasSizeBetween(760, 840);
  }

  @Test
  void theSameDatagramsAreLostEachTime() {
    act("loss video 20% burst 3");
    send(200);
    List<InMemoryPort.Sent> first = port.takeSent();

    VideoFaults again = new VideoFaults(1);
    again.set(active("loss video 20% burst 3"));
    IntStream.range(0, 200).forEach(i -> again.send(port, OPERATOR, numbered(i), i));
    assertThat(port.takeSent()).isEqualTo(first);
  }

  @Test
  void whatIsLateIsSentLater() {
    act("video-late 500ms");
    faults.send(port, OPERATOR, SLICE, 0);
    faults.deliver(495_000_000);
    assertThat(port.takeSent()).isEmpty();

    faults.deliver(500_000_000);
    assertThat(port.takeSent()).hasSize(1);
  }

  @Test
  void whatIsCorruptHasTheSameLength() {
    act("corrupt video 100%");
    faults.send(port, OPERATOR, SLICE, 0);

    assertThat(port.takeSent())
        .singleElement()
        .extracting(InMemoryPort.Sent::text)
        .matches(text -> text.length() == SLICE.length && !text.equals("\0\0\0\1e\1\2"));
  }

  @Test
  void parameterSetsAreLeftOut() {
    act("video-no-parameters");

    assertThat(packets()).containsExactly(SLICE);
  }

  @Test
  void aFrozenStreamShowsTheSameMomentUntilItIsOver() {
    Simulation simulation = new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of());
    SimSnapshot first = simulation.snapshot();
    act("video-freeze");
    assertThat(faults.shown(first)).isEqualTo(first);
    simulation.step();
    assertThat(faults.shown(simulation.snapshot())).isEqualTo(first);

    faults.set(ActiveFaults.NONE);
    assertThat(faults.shown(simulation.snapshot())).isEqualTo(simulation.snapshot());
  }

  @Test
  void whenTheSimulationBeginsAnewTheSameDatagramsAreLost() {
    Simulation simulation = new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of());
    SimSnapshot start = simulation.snapshot();
    simulation.step();
    act("loss video 20%");
    faults.shown(simulation.snapshot());
    send(100);
    List<InMemoryPort.Sent> first = port.takeSent();

    faults.shown(start);
    send(100);

    assertThat(port.takeSent()).isEqualTo(first);
  }

  @Test
  void faultsOfOtherWaysDoNothingToIt() {
    act("loss state 100%", "cut replies commands");
    send(10);

    assertThat(port.takeSent()).hasSize(10);
  }

  private void act(String... texts) {
    faults.set(active(texts));
  }

  private static ActiveFaults active(String... texts) {
    return new ActiveFaults(LinkPreset.LAB, Stream.of(texts).map(Fault::of).toList());
  }

  private void send(int datagrams) {
    IntStream.range(0, datagrams).forEach(i -> faults.send(port, OPERATOR, numbered(i), i));
  }

  private static byte[] numbered(int number) {
    return new byte[] {(byte) number, (byte) (number >> 8)};
  }

  private List<byte[]> packets() {
    return faults.packets(FakePicture.of(SEQUENCE, PICTURE, SLICE), Packetizer.RAW);
  }
}
