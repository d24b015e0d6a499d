package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.files.IoReason;
import tellosimulator.time.SimTime;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.Recording;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.VideoWatcher;
import tellosimulator.words.Phrase;

/**
 * Records the drones' videos during a flight, one file for each drone. The recorders do not start a
 * camera: they record only pictures that are encoded for other consumers. Thread-safe; pictures are
 * written on the video threads.
 */
final class VideoRecorders {

  private static final Logger LOG = LoggerFactory.getLogger(VideoRecorders.class);

  private final List<VideoRecorder> recorders = new ArrayList<>();
  private volatile Supplier<SimTime> clock = () -> SimTime.ZERO;

  /**
   * A recorded video.
   *
   * @param drone the drone's number, from 1
   * @param file the file's name
   * @param begun the time of its first picture
   */
  record RecordedVideo(int drone, String file, SimTime begun) {}

  VideoRecorders(int drones) {
    for (int drone = 1; drone <= drones; drone++) {
      recorders.add(new VideoRecorder(drone));
    }
  }

  /** Starts to watch the drones' video streams. */
  void watch(VideoStreams streams, Supplier<SimTime> newClock) {
    clock = newClock;
    recorders.forEach(recorder -> streams.stream(recorder.drone).watch(recorder));
  }

  /** Records a picture from a drone whose camera is not simulated by this program. */
  void filmed(int drone, FilmedPicture picture, SimTime now) {
    recorders.get(drone - 1).keep(picture, now);
  }

  /**
   * Begins a flight.
   *
   * @param told receives a sentence if recording a video fails
   */
  void begin(Path folder, Consumer<Phrase> told) {
    recorders.forEach(recorder -> recorder.begin(folder, told));
  }

  /** Ends the flight and returns its videos. */
  List<RecordedVideo> end() {
    return recorders.stream().flatMap(recorder -> recorder.end().stream()).toList();
  }

  /** Records the video of one drone. */
  private final class VideoRecorder implements VideoWatcher {

    private final int drone;
    private Optional<Path> file = Optional.empty();
    private Optional<Recording> film = Optional.empty();
    private Optional<SimTime> begun = Optional.empty();
    private Consumer<Phrase> told = phrase -> {};

    VideoRecorder(int drone) {
      this.drone = drone;
    }

    @Override
    public boolean needsPictures() {
      return false;
    }

    synchronized void begin(Path folder, Consumer<Phrase> newTold) {
      file = Optional.of(folder.resolve("video-" + drone + ".mp4"));
      told = newTold;
    }

    @Override
    public void filmed(FilmedPicture picture) {
      keep(picture, clock.get());
    }

    synchronized void keep(FilmedPicture picture, SimTime now) {
      if (file.isEmpty() || picture.encoded().isEmpty()) {
        return;
      }
      try {
        if (film.isEmpty()) {
          film = Optional.of(Recording.to(file.get()));
        }
        Recording kept = film.get();
        kept.filmed(picture);
        if (begun.isEmpty() && picture.encoded().get().idr()) {
          begun = Optional.of(now);
        }
        kept.failure().ifPresent(this::giveUp);
      } catch (IOException e) {
        giveUp(
            Phrase.of(
                "the recording %s ended, because it cannot be written: %s",
                file.get(), IoReason.of(e)));
      }
    }

    /** Stops recording the video for the rest of the flight. */
    private void giveUp(Phrase reason) {
      told.accept(reason);
      file = Optional.empty();
    }

    synchronized Optional<RecordedVideo> end() {
      try {
        if (film.isPresent()) {
          film.get().close();
        }
      } catch (IOException e) {
        LOG.warn("The end of the film of drone {} is missing: {}", drone, IoReason.of(e));
      }
      Optional<RecordedVideo> kept =
          begun.map(
              moment ->
                  new RecordedVideo(
                      drone, String.valueOf(film.orElseThrow().file().getFileName()), moment));
      file = Optional.empty();
      film = Optional.empty();
      begun = Optional.empty();
      return kept;
    }
  }
}
