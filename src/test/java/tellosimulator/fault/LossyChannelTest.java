package tellosimulator.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.time.SimTime;

class LossyChannelTest {

  private static final int MANY = 100_000;

  private final Log log = new Log();
  private final LossyChannel<String> channel = channel(1, log);

  /** A receiver that records nothing. */
  private static class Nothing implements LossyChannel.Receiver<String> {

    @Override
    public void arrived(String datagram) {}

    @Override
    public void lost(String datagram, Fault cause) {}

    @Override
    public String corrupted(String datagram, Corruption corruption) {
      return corruption.applied(datagram);
    }

    @Override
    public int length(String datagram) {
      return datagram.length();
    }

    @Override
    public Object party(String datagram) {
      return datagram.charAt(0);
    }
  }

  /** A receiver that records arrived and lost datagrams. */
  private static final class Log extends Nothing {

    private final List<String> arrived = new ArrayList<>();
    private final List<String> lost = new ArrayList<>();

    @Override
    public void arrived(String datagram) {
      arrived.add(datagram);
    }

    @Override
    public void lost(String datagram, Fault cause) {
      lost.add(datagram + " by " + cause.text());
    }
  }

  @Test
  void whileNothingActsEverythingArrivesAtOnce() {
    channel.send("a", true, at(1));

    assertThat(log.arrived).containsExactly("a");
    assertThat(channel.hasPending()).isFalse();
  }

  @Test
  void whileNothingActsNothingIsAllocated() {
    LossyChannel<String> ideal = channel(1, new Nothing());
    SimTime now = at(1);
    allocatedBy(ideal, now); // loads classes

    assertThat(allocatedBy(ideal, now)).isLessThan(MANY);
  }

  /** Returns the bytes allocated for many datagrams, with one step after each of them. */
  private static long allocatedBy(LossyChannel<String> channel, SimTime now) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    for (int i = 0; i < MANY; i++) {
      channel.send("a", true, now);
      channel.deliver(now);
    }
    return threads.getCurrentThreadAllocatedBytes() - before;
  }

  @Test
  void aDelayedDatagramArrivesWhenItsTimeIsOver() {
    act("delay 40ms");
    channel.send("a", true, at(1));

    channel.deliver(at(1.035));
    assertThat(log.arrived).isEmpty();
    assertThat(channel.hasPending()).isTrue();

    channel.deliver(at(1.040));
    assertThat(log.arrived).containsExactly("a");
    assertThat(channel.hasPending()).isFalse();
  }

  @Test
  void whatNobodyWaitsForIsNotOwed() {
    act("delay 40ms");
    channel.send("a", false, at(1));

    assertThat(channel.hasPending()).isFalse();
    channel.deliver(at(2));
    assertThat(log.arrived).containsExactly("a");
  }

  @Test
  void delayedDatagramsNeverOvertakeEachOther() {
    act("delay 100ms spread 300ms");
    List<String> sent = IntStream.range(0, 500).mapToObj(i -> "a" + i).toList();
    for (int i = 0; i < sent.size(); i++) {
      channel.send(sent.get(i), true, at(i * 0.01));
    }
    channel.deliver(at(100));

    assertThat(log.arrived).isEqualTo(sent);
  }

  @Test
  void delaysAreLogNormalWithinTheirLimits() {
    act("delay 100ms spread 50ms least 30ms most 300ms");
    double[] delays = delays();

    assertThat(delays[MANY / 2]).isCloseTo(0.100, within(0.0051));
    assertThat(delays[(int) (MANY * 0.84)]).isCloseTo(0.150, within(0.0051));
    assertThat(delays[0]).isBetween(0.0299, 0.036);
    assertThat(delays[MANY - 1]).isBetween(0.270, 0.3001);
  }

  /**
   * Returns the sorted delays, in steps of 5 ms, of one datagram per second, so that none waits for
   * another.
   */
  private double[] delays() {
    double[] delays = new double[MANY];
    for (int i = 0; i < MANY; i++) {
      channel.send("a", true, at(i));
      double delay = 0;
      while (log.arrived.isEmpty()) {
        delay += SimTime.STEP;
        channel.deliver(at(i + delay));
      }
      log.arrived.clear();
      delays[i] = delay;
    }
    Arrays.sort(delays);
    return delays;
  }

  @Test
  void aShareOfTheDatagramsIsLost() {
    act("loss 20%");
    sendMany();

    assertThat(log.lost.size() / (double) MANY).isCloseTo(0.2, within(0.005));
    assertThat(log.lost.get(0)).endsWith(" by loss 20%");
    assertThat(meanBurst()).as("1 / (1 - share)").isCloseTo(1.25, within(0.03));
  }

  @Test
  void inBurstsThereAreAsManyAndTheyFollowEachOther() {
    act("loss 20% burst 4");
    sendMany();

    assertThat(log.lost.size() / (double) MANY).isCloseTo(0.2, within(0.01));
    assertThat(meanBurst()).isCloseTo(4, within(0.2));
  }

  @Test
  void allOrNothingIsLostWithoutDoubt() {
    act("loss 100% burst 7");
    sendMany();
    assertThat(log.arrived).isEmpty();

    act("loss 0%");
    channel.send("a", true, at(0));
    assertThat(log.arrived).hasSize(1);
  }

  private void sendMany() {
    IntStream.range(0, MANY).forEach(i -> channel.send("a" + i, true, at(i)));
  }

  private double meanBurst() {
    long bursts = 0;
    int before = -2;
    for (String lost : log.lost) {
      int number = Integer.parseInt(lost.substring(1, lost.indexOf(' ')));
      bursts += number == before + 1 ? 0 : 1;
      before = number;
    }
    return log.lost.size() / (double) bursts;
  }

  @Test
  void duplicatesFollowAtOnce() {
    act("duplicate 20%");
    sendMany();

    assertThat(log.arrived.size() / (double) MANY).isCloseTo(1.2, within(0.005));
    assertThat(log.arrived.stream().distinct()).hasSize(MANY);
  }

  @Test
  void reorderedOnesAreOvertaken() {
    act("reorder 20% time 150ms");
    for (int i = 0; i < 1000; i++) {
      channel.deliver(at(i * 0.1));
      channel.send("a" + i, true, at(i * 0.1));
    }
    channel.deliver(at(1000));

    assertThat(log.arrived).hasSize(1000).doesNotHaveDuplicates();
    long behind =
        IntStream.range(1, 1000)
            .filter(i -> number(log.arrived.get(i)) < number(log.arrived.get(i - 1)))
            .count();
    assertThat(behind).as("those after a late one that are not late").isBetween(120L, 200L);
  }

  private static int number(String datagram) {
    return Integer.parseInt(datagram.substring(1));
  }

  @Test
  void corruptionChangesOneToThreeBytesAndNotTheLength() {
    act("corrupt 50%");
    String sent = "a".repeat(40);
    IntStream.range(0, 1000).forEach(i -> channel.send(sent, true, at(i)));

    List<Long> wrong =
        log.arrived.stream().map(got -> got.chars().filter(c -> c != 'a').count()).toList();
    assertThat(log.arrived).allMatch(got -> got.length() == 40).allMatch(LossyChannelTest::bytes);
    assertThat(wrong.stream().filter(count -> count > 0)).hasSizeBetween(440, 560);
    assertThat(wrong).allMatch(count -> count <= 3).contains(1L, 2L, 3L);
  }

  private static boolean bytes(String text) {
    return text.chars().allMatch(c -> c < 256);
  }

  /** 100 bytes with 42 bytes of headers take 10 ms at 113.6 kbit/s. */
  @Test
  void aSlowLinkTakesItsTimeAndLosesWhatItCannotKeep() {
    act("bandwidth 113.6");
    String sent = "a".repeat(100);
    IntStream.range(0, 100).forEach(i -> channel.send(sent, true, at(0)));

    channel.deliver(at(0.1001));
    assertThat(log.arrived).hasSize(10);
    channel.deliver(at(9));
    assertThat(log.arrived).as("half a second of them").hasSizeBetween(50, 52);
    assertThat(log.lost).hasSize(100 - log.arrived.size());
  }

  @Test
  void aLateReplyIsOvertakenByThoseAfterIt() {
    act("late-reply 10s");
    LossyChannel<String> replies =
        new LossyChannel<>(new SeededNoise(1, 1), LinkDirection.REPLIES, log);
    replies.set(faults("late-reply 10s"));
    replies.send("a", true, at(1));
    replies.set(ActiveFaults.NONE);
    replies.send("b", true, at(2));
    replies.deliver(at(10.9));
    assertThat(log.arrived).containsExactly("b");
    replies.deliver(at(11));
    assertThat(log.arrived).containsExactly("b", "a");
  }

  @Test
  void whatActsOnlyElsewhereDoesNothing() {
    act("loss state 100%", "cut replies", "delay state 5s");
    channel.send("a", true, at(0));

    assertThat(log.arrived).containsExactly("a");
  }

  @Test
  void whatBeganLastCountsAndStandsInForThePreset() {
    channel.set(new ActiveFaults(LinkPreset.CROWDED, List.of(Fault.of("loss 0%"))));
    IntStream.range(0, 100).forEach(i -> channel.send("a" + i, true, at(10 * i)));
    channel.deliver(at(10_000));
    assertThat(log.arrived).hasSize(100);

    act("loss 100%", "loss 0%");
    channel.send("a", true, at(20_000));
    assertThat(log.arrived).hasSize(101);
  }

  @Test
  void theSameSeedDoesTheSameAndAnotherSomethingElse() {
    assertThat(trace(1)).isEqualTo(trace(1));
    assertThat(trace(2)).isNotEqualTo(trace(1));
  }

  @Test
  void afterARestartItDoesTheSameAgain() {
    List<String> first = trace(channel, log);
    channel.restart();
    log.arrived.clear();

    assertThat(trace(channel, log)).isEqualTo(first);
  }

  private static List<String> trace(long seed) {
    Log other = new Log();
    return trace(channel(seed, other), other);
  }

  private static List<String> trace(LossyChannel<String> channel, Log log) {
    channel.set(faults("loss 20% burst 2", "duplicate", "corrupt", "reorder", "delay 90ms"));
    for (int i = 0; i < 200; i++) {
      channel.deliver(at(i * 0.1));
      channel.send("datagram " + i, true, at(i * 0.1));
    }
    channel.deliver(at(1000));
    return List.copyOf(log.arrived);
  }

  @Test
  void whatIsForgottenNeverArrives() {
    act("delay 1s");
    channel.send("a", true, at(0));
    channel.forget();
    channel.deliver(at(9));

    assertThat(log.arrived).isEmpty();
    assertThat(channel.hasPending()).isFalse();
  }

  @Test
  void ofTooManyForOnePartyTheOldestIsDropped() {
    act("delay 1s");
    channel.send("b", true, at(0));
    for (int i = 0; i < LossyChannel.MOST_FOR_PARTY + 2; i++) {
      channel.send("a" + i, true, at(0));
    }

    assertThat(channel.takeDropped()).isEqualTo(2);
    assertThat(channel.takeDropped()).isZero();
    channel.deliver(at(1));
    assertThat(log.arrived).hasSize(LossyChannel.MOST_FOR_PARTY + 1).startsWith("b", "a2");
    assertThat(channel.hasPending()).isFalse();
  }

  @Test
  void ofTooManyInAllTheOldestIsDropped() {
    act("delay 1s");
    for (int i = 0; i < LossyChannel.MOST + 3; i++) {
      channel.send((char) i + "", true, at(0));
    }

    assertThat(channel.takeDropped()).isEqualTo(3);
    channel.deliver(at(1));
    assertThat(log.arrived).hasSize(LossyChannel.MOST).startsWith((char) 3 + "");
  }

  private void act(String... texts) {
    channel.set(faults(texts));
  }

  private static ActiveFaults faults(String... texts) {
    return new ActiveFaults(LinkPreset.IDEAL, Stream.of(texts).map(Fault::of).toList());
  }

  private static LossyChannel<String> channel(long seed, Nothing log) {
    return new LossyChannel<>(new SeededNoise(seed, 1), LinkDirection.COMMANDS, log);
  }

  private static SimTime at(double seconds) {
    return SimTime.ZERO.plus(seconds);
  }
}
