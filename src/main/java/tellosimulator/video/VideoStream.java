package tellosimulator.video;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Link;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.Metronome;
import tellosimulator.time.Threads;
import tellosimulator.video.codec.EncodedPicture;
import tellosimulator.video.picture.Picture;

/**
 * One drone's video: a thread that takes the newest snapshot at each tick, films it, encodes it and
 * sends it; nothing is ever queued. It rests while nobody wants pictures.
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

  /** From picture to picture while people look and nobody takes the stream [ns]. Decided. */
  private static final long PREVIEW_PERIOD = 100_000_000;

  private final int drone;
  private final Supplier<SimSnapshot> snapshots;
  private final Films films;
  private final Metronome metronome = new Metronome();
  private final VideoConnection connection = new VideoConnection(metronome);
  private final VideoMeter meter = new VideoMeter();
  private final List<VideoWatcher> watchers = new CopyOnWriteArrayList<>();
  private final Thread thread;
  private volatile boolean closed;
  private boolean failing;
  private Wish last = Wish.NOTHING;
  private Optional<Film> begun = Optional.empty();

  /**
   * Who wants pictures.
   *
   * @param sent whether they are to be sent
   * @param encoded whether they are to be encoded
   * @param seen whether they are to be taken
   * @param link where to
   * @param start which of the operator's requests asked for it
   */
  private record Wish(boolean sent, boolean encoded, boolean seen, Link link, int start) {
    static final Wish NOTHING = new Wish(false, false, false, new Link(Optional.empty(), 0, 0), 0);
  }

  /** Starts to rest at once. */
  VideoStream(int drone, Supplier<SimSnapshot> snapshots, Films films) {
    this.drone = drone;
    this.snapshots = snapshots;
    this.films = films;
    this.thread = Threads.start("video-" + drone, this::run);
  }

  /** Shows a watcher all pictures from now on. */
  public void watch(VideoWatcher watcher) {
    watchers.add(watcher);
    wake();
  }

  /** Shows a watcher no more pictures; one may still be on its way. */
  public void ignore(VideoWatcher watcher) {
    watchers.remove(watcher);
    wake();
  }

  /** Lets it look at once whether something has changed. */
  void wake() {
    metronome.wake();
  }

  private void run() {
    while (!closed) {
      try {
        turn();
        failing = false;
      } catch (RuntimeException e) {
        if (!failing) {
          LOG.error("A picture could not be made; please report this: {}", e.toString(), e);
        }
        failing = true;
        last = Wish.NOTHING;
        Threads.backOff();
      }
    }
    connection.close();
  }

  private void turn() {
    DroneSnapshot now = drone(snapshots.get());
    Wish wish = wish(now);
    if (!wish.seen) {
      last = wish;
      connection.close();
      metronome.rest();
      return;
    }
    if ((wish.encoded && !last.encoded) || wish.start != last.start) {
      meter.restart();
      metronome.restart();
    }
    VideoFormat format = VideoFormat.of(now.state().video());
    if (metronome.awaitTick(wish.encoded ? format.period() : PREVIEW_PERIOD)) {
      SimSnapshot newest = snapshots.get();
      picture(newest, wish(drone(newest)), VideoFormat.of(drone(newest).state().video()));
    }
  }

  private void picture(SimSnapshot snapshot, Wish wish, VideoFormat format) {
    Film film = film();
    long start = metronome.nanos();
    Picture picture = film.shoot(snapshot, format);
    long filmed = metronome.nanos();
    Optional<EncodedPicture> encoded = Optional.empty();
    if (wish.encoded) {
      encoded = Optional.of(film.encode(start, !wish.equals(last)));
    }
    long done = metronome.nanos();
    last = wish;
    int bytes = encoded.map(EncodedPicture::size).orElse(0);
    VideoFigures figures =
        meter.count(new VideoMeter.Sample(start, bytes, filmed - start, done - filmed));
    if (wish.sent) { // before anybody looks at it, who may take his time
      List<byte[]> packets = Packets.of(encoded.orElseThrow());
      connection.send(packets, wish.link, spread(packets.size()));
    }
    FilmedPicture filmedPicture = new FilmedPicture(picture, encoded, figures, start);
    watchers.forEach(watcher -> tell(watcher, filmedPicture));
  }

  private Film film() {
    if (begun.isEmpty()) {
      begun = Optional.of(films.film(drone));
    }
    return begun.get();
  }

  private void tell(VideoWatcher watcher, FilmedPicture filmed) {
    try {
      watcher.filmed(filmed);
    } catch (RuntimeException e) {
      watchers.remove(watcher);
      LOG.error("Who looks at the video failed; please report this: {}", e.toString(), e);
    }
  }

  private long spread(int packets) {
    long free = Math.round((metronome.due() - metronome.nanos()) * SPREAD_SHARE);
    return Math.min(SPREAD, Math.max(free, packets * LEAST_SPREAD));
  }

  private Wish wish(DroneSnapshot now) {
    VideoSettings video = now.state().video();
    boolean powered = now.state().phase() != FlightPhase.OFF;
    boolean sent = powered && video.on() && now.link().sdkMode();
    boolean encoded = sent || (powered && watchers.stream().anyMatch(VideoWatcher::needsStream));
    boolean seen = encoded || !watchers.isEmpty();
    return new Wish(sent, encoded, seen, now.link(), video.starts());
  }

  private DroneSnapshot drone(SimSnapshot snapshot) {
    return snapshot.drones().get(drone - 1);
  }

  /** Ends the thread soon. */
  void end() {
    closed = true;
    metronome.wake();
  }

  /** Ends the thread and waits until it has ended. */
  @Override
  public void close() {
    end();
    Threads.join(thread);
  }
}
