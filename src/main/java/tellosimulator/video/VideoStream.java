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
 * The video of one drone. A thread takes the newest snapshot at each tick, renders it, encodes it
 * and sends it; nothing is ever queued. The thread is idle while no pictures are requested. After
 * running out of memory, it is idle until the next request.
 *
 * <p>{@link #watch}, {@link #ignore} and {@link #wake} are thread-safe.
 */
public final class VideoStream implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(VideoStream.class);

  /** Maximum time over which the datagrams of a picture are spread [ns]. Decided. */
  private static final long SPREAD = 16_000_000;

  /**
   * Maximum time over which the datagrams of a picture are spread, as a fraction of the time
   * remaining until the next picture. Decided.
   */
  private static final double SPREAD_SHARE = 0.8;

  /**
   * Interval between datagrams if no time remains [ns]. Decided: a machine busy with rendering must
   * not overrun a receiver that runs on the same machine.
   */
  private static final long LEAST_SPREAD = 100_000;

  /** Interval between checks of whether to try to send again [ns]. Decided. */
  private static final long LOOK_PERIOD = 100_000_000;

  /** Interval between pictures for watchers while the stream is not sent [ns]. Decided. */
  private static final long PREVIEW_PERIOD = 100_000_000;

  private final int drone;
  private final Supplier<SimSnapshot> snapshots;
  private final Supplier<FramePipeline> films;
  private final Ticker ticker = new Ticker();
  private final Reachability reachability = new Reachability(ticker::nanos);
  private final VideoFaults faults;
  private final VideoConnection connection;
  private final VideoMeter meter = new VideoMeter();
  private final List<VideoWatcher> watchers = new CopyOnWriteArrayList<>();

  private final PhotoQueue photos;

  private final Worker worker;
  private volatile boolean starved;

  /** Whether the simulation has restarted since the last picture. */
  private volatile boolean restarted;

  /** The snapshot with which the newest stream starts. */
  private volatile Optional<SimSnapshot> beginning = Optional.empty();

  /**
   * The number of the start request to which {@link #beginning} belongs. Confined to the simulation
   * thread.
   */
  private int announced;

  /** The number of key pictures that have been requested. Confined to the simulation thread. */
  private int requested;

  /** Whether a watcher has been added since the last preview. */
  private volatile boolean unseen;

  /** The content of the last picture, if it was rendered for watchers only. */
  private Optional<Seen> shown = Optional.empty();

  private int starvedAt;
  private int start;

  private StreamDemand last = StreamDemand.NOTHING;
  private Optional<FramePipeline> begun = Optional.empty();

  /**
   * Describes which pictures are needed now.
   *
   * @param sent whether pictures must be sent
   * @param encoded whether pictures must be encoded
   * @param seen whether pictures must be rendered
   * @param route the route of the datagrams
   * @param start the number of times that {@code streamon} has started the video
   * @param keyPictures the number of key pictures that have been requested
   */
  private record StreamDemand(
      boolean sent,
      boolean encoded,
      boolean seen,
      Optional<Route> route,
      int start,
      int keyPictures) {
    static final StreamDemand NOTHING =
        new StreamDemand(false, false, false, Optional.empty(), 0, 0);
  }

  /** The content and format of a frame. */
  private record Seen(CameraView view, VideoFormat format) {}

  /**
   * Creates a stream that is idle at first.
   *
   * @param films creates the frame pipeline; called on the stream's thread
   */
  VideoStream(int drone, Supplier<SimSnapshot> snapshots, Supplier<FramePipeline> films) {
    this(drone, snapshots, films, () -> WireTap.NONE);
  }

  /**
   * Creates a stream that is idle at first.
   *
   * @param films creates the frame pipeline; called on the stream's thread
   * @param taps supplies the tap for sent datagrams
   */
  VideoStream(
      int drone,
      Supplier<SimSnapshot> snapshots,
      Supplier<FramePipeline> films,
      Supplier<WireTap> taps) {
    this.drone = drone;
    this.snapshots = snapshots;
    this.films = films;
    this.faults = new VideoFaults(drone);
    this.photos = new PhotoQueue(drone);
    UnaryOperator<DatagramPort> tapped = port -> new TappedPort(drone, port, taps);
    this.connection = new VideoConnection(ticker, reachability::unreachable, faults, tapped);
    this.worker = Worker.start("video-" + drone, new Filming());
  }

  /** Adds a watcher that is notified of all pictures. */
  public void watch(VideoWatcher watcher) {
    watchers.add(watcher);
    unseen = true;
    starved = false;
    wake();
  }

  /** Removes a watcher. The watcher may still be notified of one more picture. */
  public void ignore(VideoWatcher watcher) {
    watchers.remove(watcher);
    wake();
  }

  /** Records that the simulation has restarted; the next picture to be sent begins a new stream. */
  void restart() {
    announced = 0;
    beginning = Optional.empty();
    restarted = true;
  }

  /** Records that the drone's operator has sent something. */
  void heard() {
    reachability.heard();
  }

  /**
   * Called on the simulation thread after each event of the drone. If the drone has just started to
   * stream, the first picture will show the current snapshot, no matter how late the video thread
   * wakes up.
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

  /**
   * Called on the simulation thread after each step. The app's protocol starts the video and
   * requests key pictures without an event.
   */
  void stepped(VideoSettings video) {
    if ((video.on() && video.starts() != announced) || video.keyPictures() != requested) {
      requested = video.keyPictures();
      happened();
    }
  }

  /** Makes the thread check for changes immediately. */
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
      last = StreamDemand.NOTHING;
      if (!Exceptions.isFatal(failure)) {
        return failed;
      }
      begun = Optional.empty(); // the pipeline takes most of a stream's memory
      starvedAt = start;
      starved = true;
      return resting;
    }

    @Override
    public void onClose() {
      photos.close();
      connection.close();
    }
  }

  /**
   * Takes a photo of a snapshot on the stream's thread. The video stands still meanwhile, as on the
   * real drone. Thread-safe.
   *
   * @return waits for the photo, and supplies it as a JPEG file; empty if it failed
   */
  Supplier<byte[]> photo(SimSnapshot snapshot, float quality) {
    Supplier<byte[]> photo = photos.add(() -> film().photo(snapshot, quality));
    wake();
    return photo;
  }

  private boolean turn() {
    photos.takeAll();
    forgetIfRestarted();
    DroneSnapshot now = drone(snapshots.get());
    StreamDemand wish = wish(now);
    if (wish.keyPictures != last.keyPictures || wish.start != last.start) {
      reachability.heard(); // the app's protocol has no other sign of life
    }
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

  /**
   * Returns the snapshot to be shown: for the first picture of a stream, the snapshot with which
   * the stream starts; otherwise, the newest snapshot.
   */
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

  /**
   * Resets the stream if the simulation has restarted. A restarted simulation counts start requests
   * from 0 again, so the next request may have the same number as the last one.
   */
  private void forgetIfRestarted() {
    if (restarted) {
      restarted = false;
      last = StreamDemand.NOTHING;
      connection.close();
    }
  }

  private void film(SimSnapshot newest) {
    forgetIfRestarted();
    DroneSnapshot now = drone(newest);
    faults.set(now.faults());
    faults.deliver(ticker.nanos());
    StreamDemand wish = wish(now);
    VideoFormat format = VideoFormat.of(now.state().video());
    SimSnapshot filmed = faults.shown(newest);
    if (wish.encoded) {
      shown = Optional.empty();
      picture(filmed, wish, format);
    } else {
      preview(filmed, wish, format);
    }
  }

  /** Renders a picture for watchers, unless it would be the same as the last one. */
  private void preview(SimSnapshot snapshot, StreamDemand wish, VideoFormat format) {
    Optional<Seen> seen = film().view(snapshot, format).map(view -> new Seen(view, format));
    if (unseen || seen.isEmpty() || !seen.equals(shown)) {
      unseen = false;
      shown = Optional.empty(); // in case rendering fails
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

  private void picture(SimSnapshot snapshot, StreamDemand wish, VideoFormat format) {
    FramePipeline film = film();
    if (wish.encoded && wish.start != last.start) {
      film.restart();
    }
    long start = ticker.nanos();
    Picture picture = film.capture(snapshot, format);
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
    if (wish.sent) { // before watchers, which may be slow
      Route route = wish.route.orElseThrow();
      List<byte[]> packets = faults.packets(encoded.orElseThrow(), route.packetizer());
      connection.send(packets, route, spread(packets.size()));
    }
    FilmedPicture filmedPicture = new FilmedPicture(picture, encoded, figures, start);
    watchers.forEach(watcher -> tell(watcher, filmedPicture));
  }

  private FramePipeline film() {
    if (begun.isEmpty()) {
      begun = Optional.of(films.get());
    }
    return begun.get();
  }

  private void tell(VideoWatcher watcher, FilmedPicture filmed) {
    try {
      watcher.filmed(filmed);
    } catch (Throwable e) { // a failing watcher must not affect the stream
      Exceptions.throwIfFatal(e);
      watchers.remove(watcher);
      LOG.error("A receiver of the video failed; please report this: {}", e.toString(), e);
    }
  }

  private long spread(int packets) {
    long free = Math.round((ticker.due() - ticker.nanos()) * SPREAD_SHARE);
    return Math.min(SPREAD, Math.max(free, packets * LEAST_SPREAD));
  }

  private StreamDemand wish(DroneSnapshot now) {
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
    return new StreamDemand(
        sent, encoded, seen, Route.of(now.link()), video.starts(), video.keyPictures());
  }

  private DroneSnapshot drone(SimSnapshot snapshot) {
    return snapshot.drones().get(drone - 1);
  }

  /** Makes the thread end, but does not wait until it has ended. */
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
