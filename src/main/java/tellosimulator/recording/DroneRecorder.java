package tellosimulator.recording;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.Worker;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Progress;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;
import tellosimulator.words.Phrase;

/**
 * Records the flights of a real drone from its network traffic. Each flight is recorded into its
 * own folder. Because only the traffic is known, a flight begins with the takeoff command. The
 * flight ends three seconds after {@code land} was answered with {@code ok}, after {@code
 * emergency}, or after the takeoff was refused. In the app's protocol, which answers a landing at
 * its beginning, it ends {@link #LANDING} later. It also ends when the operator has been silent for
 * a minute. Recorded times count from the creation of the recorder.
 *
 * <p>The calling thread only adds records to a queue. Not thread-safe, except for {@link #close},
 * which must be the last call.
 */
public final class DroneRecorder implements AutoCloseable {

  /**
   * How long recording continues after the drone has landed [ns]. Decided: as for simulated
   * flights.
   */
  private static final long REST = 3_000_000_000L;

  /**
   * Silence of the operator after which the drone must have landed by itself [ns]. A drone lands
   * after 15 s of silence (documented: SDK 2.0 User Guide). Decided: a minute, because no move
   * takes longer.
   */
  private static final long SILENCE = 60_000_000_000L;

  /** Time from the answer to a landing in the app's protocol until it is over [ns]. Decided. */
  private static final long LANDING = 10_000_000_000L;

  /** The packets of the app's protocol that make a drone take off. */
  private static final Set<String> APP_TAKEOFFS = Set.of("takeoff (app)", "throw and go (app)");

  /** The packets of the app's protocol that make a drone land. */
  private static final Set<String> APP_LANDINGS = Set.of("land (app)", "palm landing (app)");

  private static final Progress NO_GOALS =
      new Progress(Challenge.NONE, List.of(), 0, Optional.empty());

  private final EntryQueue queue = new EntryQueue();
  private final Worker worker;
  private final long origin = WallTime.nanoTime();
  private boolean flying;

  /** Whether the last takeoff has not been answered yet. */
  private boolean takingOff;

  /** Whether the last landing has not been answered yet. */
  private boolean landing;

  /** Time of landing [ns]; empty while the drone flies. */
  private OptionalLong down = OptionalLong.empty();

  private long lastCommand = origin;
  private long last = origin;

  private DroneRecorder(
      RecordingFolder folder, InetAddress drone, List<String> options, Consumer<Phrase> told) {
    FlightSource source = new FlightSource.Real(drone, options);
    worker =
        Worker.start(
            "recorder",
            new RecordingWriter(new RecordingWriter.Sources(queue, 1), folder, source, told));
  }

  /**
   * Starts a recorder that waits for the first takeoff.
   *
   * @param folder the folder that will contain a folder for each flight
   * @param drone the drone's address
   * @param options the command-line arguments
   * @param told receives a sentence for users when recording a flight fails; called on the
   *     recorder's thread. The sentence is also logged
   */
  public static DroneRecorder start(
      RecordingFolder folder, InetAddress drone, List<String> options, Consumer<Phrase> told) {
    return new DroneRecorder(folder, drone, options, told);
  }

  /**
   * Records an operator's command.
   *
   * @param nanos the time of receipt, on the clock of {@link WallTime#nanoTime}
   * @param from the operator
   * @param to the drone
   */
  public void command(long nanos, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {
    String verb = NamedPacket.text(bytes).strip();
    tick(nanos);
    if (WirePairing.TAKEOFFS.contains(verb) || APP_TAKEOFFS.contains(verb)) {
      takeOff(nanos);
    } else if (verb.equals("land")) {
      landing = true;
    } else if (verb.equals("emergency")) {
      isDown(nanos);
    } else if (verb.equals("stop landing (app)")) {
      down = OptionalLong.empty();
    }
    lastCommand = nanos;
    SimInput datagram = new SimInput.Datagram(1, new Peer(from, to), bytes);
    queue.add(new Entry.Input(time(nanos), nanos, datagram));
  }

  /**
   * Records a datagram sent by the drone.
   *
   * @param nanos the time of receipt, on the clock of {@link WallTime#nanoTime}
   * @param from the drone
   * @param to the operator
   * @param bytes must not be modified afterwards
   */
  public void sent(
      long nanos, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {
    tick(nanos);
    if (kind == Kind.REPLY) {
      NamedPacket.of(bytes)
          .ifPresentOrElse(
              packet -> reply(nanos, packet), () -> reply(nanos, WireText.decode(bytes).strip()));
    }
    queue.add(new Entry.Sent(time(nanos), nanos, 1, kind, new Entry.Ends(from, to), bytes));
  }

  private void takeOff(long nanos) {
    if (flying && down.isPresent()) {
      finish(nanos);
    }
    if (!flying) { // if already flying, the drone refuses the takeoff
      flying = true;
      takingOff = true;
      queue.add(new Entry.Begin(WallTime.now(), time(nanos), Optional.empty()));
    }
  }

  private void reply(long nanos, String text) {
    boolean refused = text.startsWith("error");
    if (landing && text.equals("ok")) {
      isDown(nanos);
    } else if (takingOff && refused && !text.equals(Reply.NOT_JOYSTICK.text())) {
      isDown(nanos);
    }
    takingOff &= !text.equals("ok") && (!refused || text.equals(Reply.NOT_JOYSTICK.text()));
    landing &= !text.equals("ok") && (!refused || text.equals(Reply.AUTO_LAND.text()));
  }

  /** Processes an answer in the app's protocol. */
  private void reply(long nanos, NamedPacket packet) {
    boolean refused = packet.reply().filter(Reply.ERROR.text()::equals).isPresent();
    if (takingOff && APP_TAKEOFFS.contains(packet.words())) {
      takingOff = false;
      if (refused) {
        isDown(nanos);
      }
    } else if (!refused && APP_LANDINGS.contains(packet.words())) {
      isDown(nanos + LANDING);
    }
  }

  private void isDown(long nanos) {
    if (flying && down.isEmpty()) {
      down = OptionalLong.of(nanos);
    }
  }

  /**
   * Advances the time. This may end a flight even if nothing is received.
   *
   * @param nanos the time on the clock of {@link WallTime#nanoTime}
   */
  public void tick(long nanos) {
    last = Math.max(last, nanos);
    boolean rested = down.isPresent() && nanos - down.getAsLong() >= REST;
    if (flying && (rested || nanos - lastCommand >= SILENCE)) {
      finish(nanos);
    }
  }

  private void finish(long nanos) {
    flying = false;
    takingOff = false;
    landing = false;
    down = OptionalLong.empty();
    queue.add(new Entry.End(time(nanos), NO_GOALS, 0));
  }

  private SimTime time(long nanos) {
    return new SimTime(Math.max(0, nanos - origin));
  }

  /** Ends the current flight and writes all queued records. */
  @Override
  public void close() {
    if (flying) {
      finish(last);
    }
    worker.end();
    queue.wake();
    worker.close();
  }
}
