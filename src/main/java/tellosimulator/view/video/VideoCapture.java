package tellosimulator.view.video;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.files.IoReason;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.Recording;
import tellosimulator.video.VideoStream;
import tellosimulator.video.VideoWatcher;
import tellosimulator.video.picture.Picture;
import tellosimulator.words.Phrase;

/**
 * Saves a drone's video: single pictures as PNG files, or a recording as an MP4 file. Confined to
 * the JavaFX thread, except {@link #close}.
 */
public final class VideoCapture implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(VideoCapture.class);
  private static final ErrorPolicy UNSAVED = ErrorPolicy.finish("A picture could not be saved");
  private static final double NANOS_PER_SECOND = 1e9;

  private final Source source;
  private final MediaFolder folder;
  private final Consumer<Report> reports;
  private final ReadOnlyBooleanWrapper recording = new ReadOnlyBooleanWrapper(this, "recording");
  private final ReadOnlyIntegerWrapper seconds = new ReadOnlyIntegerWrapper(this, "seconds");
  private final Set<Worker> writing = ConcurrentHashMap.newKeySet();
  private volatile Optional<Recording> film = Optional.empty();
  private long begunNanos;

  /**
   * The source of the pictures.
   *
   * @param drone the number of the drone, from 1
   * @param powered whether the drone is on
   */
  record Source(int drone, VideoStream stream, BooleanSupplier powered) {}

  /**
   * Creates a capture.
   *
   * @param reports receives the result for each file, on any thread
   */
  VideoCapture(Source source, MediaFolder folder, Consumer<Report> reports) {
    this.source = source;
    this.folder = folder;
    this.reports = reports;
  }

  /** Whether a recording is in progress. */
  public ReadOnlyBooleanProperty recordingProperty() {
    return recording.getReadOnlyProperty();
  }

  /** The duration of the recording [s]. */
  public ReadOnlyIntegerProperty secondsProperty() {
    return seconds.getReadOnlyProperty();
  }

  /** Saves the next picture of the stream. */
  public void saveStill() {
    LocalDateTime moment = LocalDateTime.now(ZoneId.systemDefault());
    NextPicture.take(
        source.stream,
        picture -> {
          Worker writer = Worker.once("still", UNSAVED, () -> save(picture, moment));
          writing.removeIf(Worker::hasEnded);
          writing.add(writer);
        });
  }

  private void save(Picture picture, LocalDateTime moment) {
    try {
      say(true, Phrase.of("a picture was saved: %s", written(picture, moment)));
    } catch (IOException e) {
      say(false, Phrase.of("a picture could not be saved: %s", IoReason.of(e)));
    }
  }

  /** Writes a picture to a new file, even if other writers try the same name at the same time. */
  private Path written(Picture picture, LocalDateTime moment) throws IOException {
    while (true) {
      Path file = folder.picture(source.drone, moment);
      try {
        PngWriter.write(picture, file);
        return file;
      } catch (FileAlreadyExistsException e) {
        LOG.debug("{} is another picture's by now", file);
      }
    }
  }

  /** Starts or stops a recording. A drone that is off cannot be recorded. */
  public void toggleRecording() {
    if (film.isPresent()) {
      end();
    } else if (!source.powered.getAsBoolean()) {
      say(false, Phrase.of("the drone is off, so there is nothing to record"));
    } else {
      begin();
    }
  }

  private void begin() {
    try {
      Recording begun =
          Recording.to(folder.film(source.drone, LocalDateTime.now(ZoneId.systemDefault())));
      film = Optional.of(begun);
      begunNanos = System.nanoTime();
      seconds.set(0);
      recording.set(true);
      source.stream.watch(begun);
      say(true, Phrase.of("the video is being recorded: %s", begun.file()));
    } catch (IOException e) {
      say(false, Phrase.of("the video cannot be recorded: %s", IoReason.of(e)));
    }
  }

  /**
   * Updates the duration, and stops a recording that has failed or whose drone is off. Must be
   * called once per UI tick.
   */
  void advance() {
    if (film.isEmpty()) {
      return;
    }
    if (film.get().failure().isPresent() || !source.powered.getAsBoolean()) {
      end();
    } else {
      seconds.set((int) ((System.nanoTime() - begunNanos) / NANOS_PER_SECOND));
    }
  }

  private void end() {
    closeFilm();
    recording.set(false);
  }

  /** Stops the recording, and waits until all pictures have been saved. Thread-safe. */
  @Override
  public void close() {
    closeFilm();
    writing.forEach(Worker::close);
  }

  private synchronized void closeFilm() {
    film.ifPresent(
        ended -> {
          film = Optional.empty();
          source.stream.ignore(ended);
          report(ended);
        });
  }

  private void report(Recording ended) {
    try {
      ended.close();
      if (ended.failure().isPresent()) {
        say(false, ended.failure().get());
      } else if (ended.pictures() == 0) {
        say(false, Phrase.of("no picture came, so nothing was recorded"));
      } else {
        say(
            true,
            Phrase.of("the video was recorded, %d pictures: %s", ended.pictures(), ended.file()));
      }
    } catch (IOException e) {
      say(
          false,
          Phrase.of(
              "the end of the recording %s may be missing: %s", ended.file(), IoReason.of(e)));
    }
  }

  private void say(boolean good, Phrase phrase) {
    reports.accept(new Report(source.drone, good, phrase));
  }

  /** Waits for the next picture of a stream and passes on a copy. Thread-safe. */
  private static final class NextPicture implements VideoWatcher {

    private final AtomicBoolean waiting = new AtomicBoolean(true);
    private final VideoStream stream;
    private final Consumer<Picture> taker;

    private NextPicture(VideoStream stream, Consumer<Picture> taker) {
      this.stream = stream;
      this.taker = taker;
    }

    /**
     * Requests the next picture.
     *
     * @param taker called once, on the video thread
     */
    static void take(VideoStream stream, Consumer<Picture> taker) {
      stream.watch(new NextPicture(stream, taker));
    }

    @Override
    public void filmed(FilmedPicture filmed) {
      if (waiting.getAndSet(false)) {
        stream.ignore(this);
        taker.accept(filmed.picture().copy());
      }
    }
  }

  /**
   * The result of saving a picture or a recording.
   *
   * @param drone the number of the drone, from 1
   * @param good whether the picture or recording was saved
   */
  public record Report(int drone, boolean good, Phrase phrase) {}
}
