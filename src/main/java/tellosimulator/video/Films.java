package tellosimulator.video;

import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.VideoEncoder;

/**
 * Makes the film of each drone. The first picture of the first drone can be made before anybody
 * asks for it. For any thread.
 */
public final class Films {

  private static final int FIRST = 1;

  private final Supplier<FrameSource> sources;
  private final VideoEncoder.Factory encoders;
  private Optional<Film> prepared = Optional.empty();
  private boolean begun;

  /**
   * @param sources where pictures come from; it takes one for each film
   */
  public Films(Supplier<FrameSource> sources, VideoEncoder.Factory encoders) {
    this.sources = sources;
    this.encoders = encoders;
  }

  /**
   * Makes the first picture of the first drone in advance, or again if meanwhile there is something
   * else to see. Returns when it is there; does nothing once that drone films.
   *
   * @param snapshot what it sees
   */
  synchronized void prepare(SimSnapshot snapshot) {
    if (!begun) {
      Film film = prepared.orElseGet(() -> fresh(FIRST));
      prepared = Optional.empty(); // unless all goes well
      film.prepare(snapshot, VideoFormat.of(snapshot.drones().get(0).state().video()));
      prepared = Optional.of(film);
    }
  }

  /** The same, unless there is one already, which then is of something newer. */
  synchronized void prepareEarly(SimSnapshot snapshot) {
    if (prepared.isEmpty()) {
      prepare(snapshot);
    }
  }

  /**
   * The film of a drone, which asks once. That of the first drone may have its first picture
   * already; while that is being made, it waits.
   *
   * @param drone its number, from 1
   */
  Film film(int drone) {
    return drone == FIRST ? first() : fresh(drone);
  }

  private synchronized Film first() {
    begun = true;
    Film film = prepared.orElseGet(() -> fresh(FIRST));
    prepared = Optional.empty();
    return film;
  }

  /** One more film that nobody else has. */
  Film fresh(int drone) {
    return new Film(drone, sources.get(), encoders);
  }
}
