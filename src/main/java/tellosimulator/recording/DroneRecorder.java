package tellosimulator.recording;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import tellosimulator.command.Reply;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.Worker;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Progress;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;
import tellosimulator.words.Phrase;

/**
 * Records the flights of a real drone by what passes on the wire, each into a folder of its own.
 * Nothing else is known of it, so a flight goes from the command that lets it take off until three
 * seconds after {@code land} was answered with {@code ok}, after {@code emergency}, or after the
 * takeoff was refused; or until its operator has been silent for long. Seconds are those since the
 * recorder was made.
 *
 * <p>On the thread that tells it what passes it only puts records into a queue. For one thread, but
 * for {@link #close}, which comes last.
 */
public final class DroneRecorder implements AutoCloseable {

  /** How long is recorded after the drone has come down [ns]. Decided: as for simulated flights. */
  private static final long REST = 3_000_000_000L;

  /**
   * Silence of the operator after which the drone has landed by itself [ns]. It does so after 15 s
   * (documented: SDK 2.0 User Guide); decided: a minute, as no move takes longer.
   */
  private static final long SILENCE = 60_000_000_000L;

  private static final GoalResult NO_GOALS =
      new GoalResult(new Progress(Challenge.NONE, List.of(), 0, Optional.empty()), 0);

  private final EntryQueue queue = new EntryQueue();
  private final Worker worker;
  private final long origin = WallTime.nanoTime();
  private boolean flying;

  /** Whether the last takeoff, or the last landing, waits for its reply. */
  private boolean takingOff;

  private boolean landing;

  /** When it was down [ns]; empty while it flies. */
  private OptionalLong down = OptionalLong.empty();

  private long lastCommand = origin;
  private long last = origin;

  private DroneRecorder(
      RecordingFolder folder, InetAddress drone, List<String> options, Consumer<Phrase> told) {
    FlightSource source = new FlightSource.Real(drone, options);
    worker =
        Worker.start(
            "recorder",
            new RecordingWriter(
                new RecordingWriter.Sources(queue, new VideoRecorders(1), new InputHistory()),
                folder,
                source,
                told));
  }

  /**
   * Waits for the first takeoff.
   *
   * @param folder in which there will be a folder for each flight
   * @param drone its address
   * @param options words of the command line
   * @param told takes a sentence for people when a flight cannot be recorded any more; on the
   *     recorder's thread, and the log has it too
   */
  public static DroneRecorder start(
      RecordingFolder folder, InetAddress drone, List<String> options, Consumer<Phrase> told) {
    return new DroneRecorder(folder, drone, options, told);
  }

  /**
   * An operator's command has passed.
   *
   * @param nanos when it came, on the clock of {@link WallTime#nanoTime}
   * @param from the operator
   * @param to the drone
   */
  public void command(long nanos, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {
    String text = WireText.decode(bytes, bytes.length);
    String verb = text.strip();
    tick(nanos);
    if (WirePairing.TAKEOFFS.contains(verb)) {
      takeOff(nanos);
    } else if (verb.equals("land")) {
      landing = true;
    } else if (verb.equals("emergency")) {
      isDown(nanos);
    }
    lastCommand = nanos;
    queue.add(new Entry.Received(time(nanos), nanos, 1, new Entry.Ends(from, to), text));
  }

  /**
   * What the drone has sent has passed.
   *
   * @param nanos when it came, on the clock of {@link WallTime#nanoTime}
   * @param from the drone
   * @param to the operator
   * @param bytes nobody changes them afterwards
   */
  public void sent(
      long nanos, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {
    tick(nanos);
    if (kind == Kind.REPLY) {
      reply(nanos, WireText.decode(bytes, bytes.length).strip());
    }
    queue.add(new Entry.Sent(time(nanos), nanos, 1, kind, new Entry.Ends(from, to), bytes));
  }

  private void takeOff(long nanos) {
    if (flying && down.isPresent()) {
      finish(nanos);
    }
    if (!flying) { // or the drone is in the air, and refuses it
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

  private void isDown(long nanos) {
    if (flying && down.isEmpty()) {
      down = OptionalLong.of(nanos);
    }
  }

  /**
   * Time passes: a flight may be over, though nothing comes.
   *
   * @param nanos on the clock of {@link WallTime#nanoTime}
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
    queue.add(new Entry.End(time(nanos), NO_GOALS));
  }

  private SimTime time(long nanos) {
    return new SimTime(Math.max(0, nanos - origin));
  }

  /** Ends the flight that is recorded, and writes what waits. */
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
