package tellosimulator.video;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.concurrent.Worker;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.VideoSettings;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.WireTap;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.Ticker;
import tellosimulator.video.VideoConnection.Route;
import tellosimulator.video.camera.CameraView;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.picture.Picture;

/**
 * One drone's video: a thread that takes the newest snapshot at each tick, films it, encodes it and
 * sends it; nothing is ever queued. It rests while nobody wants pictures, and after memory was not
 * enough for one, until somebody asks anew.
 *
 * <p>{@link #watch}, {@link #ignore} and {@link #wake} are for any thread.
 */
public final class VideoStream implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(VideoStream.class);

  /** Longest time over which the datagrams of a picture are spread [ns]. Decided. */
  private static final long SPREAD = 16_000_000;

  /** Part of the free time until the next picture that may be used for it. Decided. */
  private static final double SPREAD_SHARE = 0.8;

  /**
   * Time from datagram to datagram where none is free [ns]. Decided: a machine that is busy with
   * filming must not overrun the receiver on it.
   */
  private static final long LEAST_SPREAD = 100_000;

  /** From look to look between two tries [ns]. Decided. */
  private static final long LOOK_PERIOD = 100_000_000;

  /** From picture to picture while people look and nobody takes the stream [ns]. Decided. */
  private static final long PREVIEW_PERIOD = 100_000_000;

  private final int drone;
  private final Supplier<SimSnapshot> snapshots;
  private final Supplier<Film> films;
  private final Ticker ticker = new Ticker();
  private final Reachability reachability = new Reachability(ticker::nanos);
  private final VideoFaults faults;
  private final VideoConnection connection;
  private final VideoMeter meter = new VideoMeter();
  private final List<VideoWatcher> watchers = new CopyOnWriteArrayList<>();
  private final Worker worker;
  private volatile boolean starved;

  /** Whether the simulation has begun anew since the last picture. */
  private volatile boolean anew;

  /** The step at which the newest stream begins. */
  private volatile Optional<SimSnapshot> beginning = Optional.empty();

  /** Which of the operator's requests that is; for the simulation thread. */
  private int announced;

  /** Whether somebody looks who has seen no picture yet. */
  private volatile boolean unseen;

  /** What the last picture showed, if it was only for those who look. */
  private Optional<Seen> shown = Optional.empty();

  private int starvedAt;
  private int start;

  private Wish last = Wish.NOTHING;
  private Optional<Film> begun = Optional.empty();

  /**
   * Who wants pictures.
   *
   * @param sent whether they are to be sent
   * @param encoded whether they are to be encoded
   * @param seen whether they are to be taken
   * @param route where to
   * @param start which of the operator's requests asked for it
   */
  private record Wish(
      boolean sent, boolean encoded, boolean seen, Optional<Route> route, int start) {
    static final Wish NOTHING = new Wish(false, false, false, Optional.empty(), 0);
  }

  /** What a frame shows, and in which format. */
  private record Seen(CameraView view, VideoFormat format) {}

  /**
   * Starts to rest at once.
   *
   * @param films creates what renders and encodes; called on the stream's thread
   */
  VideoStream(int drone, Supplier<SimSnapshot> snapshots, Supplier<Film> films) {
    this(drone, snapshots, films, () -> WireTap.NONE);
  }

  /**
   * Starts to rest at once.
   *
   * @param films creates what renders and encodes; called on the stream's thread
   * @param taps who sees what is sent
   */
  VideoStream(
      int drone, Supplier<SimSnapshot> snapshots, Supplier<Film> films, Supplier<WireTap> taps) {
    this.drone = drone;
    this.snapshots = snapshots;
    this.films = films;
    this.faults = new VideoFaults(drone);
    UnaryOperator<DatagramPort> tapped = port -> new TappedPort(drone, port, taps);
    this.connection = new VideoConnection(ticker, reachability::unreachable, faults, tapped);
    this.worker = Worker.start("video-" + drone, new Filming());
  }

  /** Shows a watcher all pictures from now on. */
  public void watch(VideoWatcher watcher) {
    watchers.add(watcher);
    unseen = true;
    starved = false;
    wake();
  }

  /** Shows a watcher no more pictures; one may still be on its way. */
  public void ignore(VideoWatcher watcher) {
    watchers.remove(watcher);
    wake();
  }

  /** The simulation has begun anew: the next picture that is sent begins a stream. */
  void restart() {
    announced = 0;
    beginning = Optional.empty();
    anew = true;
  }

  /** The drone's operator has sent something. */
  void heard() {
    reachability.heard();
  }

  /**
   * Something happened to the drone, perhaps that it was told to film: the first picture shows this
   * step, however late the thread of the video wakes up. For the simulation thread.
   */
  void happened() {
    SimSnapshot now = snapshots.get();
    VideoSettings video = drone(now).state().video();
    if (video.on() && video.starts() != announced) {
      announced = video.starts();
      beginning = Optional.of(now);
    }
    wake();
  }

  /** Lets it look at once whether something has changed. */
  void wake() {
    ticker.wake();
  }

  private final class Filming implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("A picture of drone " + drone + " failed");
    private final ErrorPolicy resting =
        ErrorPolicy.goOn("The video of drone " + drone + " rests until the next streamon");

    @Override
    public Outcome doWork() {
      return turn() ? Outcome.WORKED : Outcome.IDLE;
    }

    @Override
    public void idle() {
      ticker.rest();
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      last = Wish.NOTHING;
      if (!Exceptions.isFatal(failure)) {
        return failed;
      }
      begun = Optional.empty(); // the largest part of the memory that a stream takes
      starvedAt = start;
      starved = true;
      return resting;
    }

    @Override
    public void onClose() {
      connection.close();
    }
  }

  private boolean turn() {
    forgetIfAnew();
    DroneSnapshot now = drone(snapshots.get());
    Wish wish = wish(now);
    start = wish.start;
    if (resting(now) || !wish.seen) {
      last = wish;
      connection.close();
      if (!reachability.triesAgain(now.link())) {
        return false;
      }
      ticker.pauseUntil(ticker.nanos() + LOOK_PERIOD);
      return true;
    }
    if ((wish.encoded && !last.encoded) || wish.start != last.start) {
      meter.restart();
      ticker.restart();
    }
    VideoFormat format = VideoFormat.of(now.state().video());
    if (ticker.awaitTick(wish.encoded ? format.period() : PREVIEW_PERIOD)) {
      film(due());
    }
    return true;
  }

  /** The step at which a stream begins, for its first picture; then the newest. */
  private SimSnapshot due() {
    SimSnapshot newest = snapshots.get();
    int wanted = starts(newest);
    return wanted == last.start
        ? newest
        : beginning.filter(step -> starts(step) == wanted).orElse(newest);
  }

  private int starts(SimSnapshot snapshot) {
    return drone(snapshot).state().video().starts();
  }

  /** Requests are counted from the simulation's start, so the next one may look like the last. */
  private void forgetIfAnew() {
    if (anew) {
      anew = false;
      last = Wish.NOTHING;
      connection.close();
    }
  }

  private void film(SimSnapshot newest) {
    forgetIfAnew();
    DroneSnapshot now = drone(newest);
    faults.set(now.faults());
    faults.deliver(ticker.nanos());
    Wish wish = wish(now);
    VideoFormat format = VideoFormat.of(now.state().video());
    SimSnapshot filmed = faults.shown(newest);
    if (wish.encoded) {
      shown = Optional.empty();
      picture(filmed, wish, format);
    } else {
      preview(filmed, wish, format);
    }
  }

  /** Takes a picture for those who look, unless it would be as the last one. */
  private void preview(SimSnapshot snapshot, Wish wish, VideoFormat format) {
    Optional<Seen> seen = film().view(snapshot, format).map(view -> new Seen(view, format));
    if (unseen || seen.isEmpty() || !seen.equals(shown)) {
      unseen = false;
      shown = Optional.empty(); // if it fails
      picture(snapshot, wish, format);
      shown = seen;
    }
  }

  private boolean resting(DroneSnapshot now) {
    if (start != starvedAt || now.state().phase() == FlightPhase.OFF) {
      starved = false;
    }
    return starved;
  }

  private void picture(SimSnapshot snapshot, Wish wish, VideoFormat format) {
    Film film = film();
    if (wish.encoded && wish.start != last.start) {
      film.restart();
    }
    long start = ticker.nanos();
    Picture picture = film.shoot(snapshot, format);
    long filmed = ticker.nanos();
    Optional<AccessUnit> encoded = Optional.empty();
    if (wish.encoded) {
      encoded = Optional.of(film.encode(start, !wish.equals(last)));
    }
    long done = ticker.nanos();
    last = wish;
    int bytes = encoded.map(AccessUnit::size).orElse(0);
    VideoFigures figures =
        meter.count(new VideoMeter.Sample(start, bytes, filmed - start, done - filmed));
    if (wish.sent) { // before anybody looks at it, who may take his time
      List<byte[]> packets = faults.sent(Packets.of(encoded.orElseThrow()));
      connection.send(packets, wish.route.orElseThrow(), spread(packets.size()));
    }
    FilmedPicture filmedPicture = new FilmedPicture(picture, encoded, figures, start);
    watchers.forEach(watcher -> tell(watcher, filmedPicture));
  }

  private Film film() {
    if (begun.isEmpty()) {
      begun = Optional.of(films.get());
    }
    return begun.get();
  }

  private void tell(VideoWatcher watcher, FilmedPicture filmed) {
    try {
      watcher.filmed(filmed);
    } catch (Throwable e) { // whatever it is, the stream shall not suffer
      Exceptions.throwIfFatal(e);
      watchers.remove(watcher);
      LOG.error("Who looks at the video failed; please report this: {}", e.toString(), e);
    }
  }

  private long spread(int packets) {
    long free = Math.round((ticker.due() - ticker.nanos()) * SPREAD_SHARE);
    return Math.min(SPREAD, Math.max(free, packets * LEAST_SPREAD));
  }

  private Wish wish(DroneSnapshot now) {
    VideoSettings video = now.state().video();
    boolean powered = now.state().phase() != FlightPhase.OFF;
    boolean sent =
        powered
            && video.on()
            && now.link().sdkMode()
            && !VideoFaults.silent(now.faults())
            && !reachability.rests(now.link());
    boolean encoded = sent || (powered && watchers.stream().anyMatch(VideoWatcher::needsStream));
    boolean seen = encoded || watchers.stream().anyMatch(VideoWatcher::needsPictures);
    return new Wish(sent, encoded, seen, Route.of(now.link()), video.starts());
  }

  private DroneSnapshot drone(SimSnapshot snapshot) {
    return snapshot.drones().get(drone - 1);
  }

  /** Ends the thread soon. */
  void end() {
    worker.end();
    ticker.wake();
  }

  /** Ends the thread and waits until it has ended. */
  @Override
  public void close() {
    end();
    worker.close();
  }
}
