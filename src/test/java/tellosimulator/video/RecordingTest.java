package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.jcodec.api.FrameGrab;
import org.jcodec.api.JCodecException;
import org.jcodec.common.DemuxerTrack;
import org.jcodec.common.io.FileChannelWrapper;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.containers.mp4.demuxer.MP4Demuxer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.Ffmpeg;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;
import tellosimulator.words.Phrase;

class RecordingTest {

  private static final long PERIOD = 40_000_000;

  @TempDir private Path folder;

  private Path file;
  private Recording recording;
  private H264Encoder encoder = new H264Encoder(64, 48);
  private long now = 5_000_000_000L;

  @BeforeEach
  void begin() throws IOException {
    file = folder.resolve("flight.mp4");
    recording = Recording.to(file);
  }

  @Test
  void theFileShowsThePicturesForAsLongAsTheyLasted() throws IOException, JCodecException {
    for (int i = 0; i < 50; i++) {
      film(64, 48, 100 + i, i % 25 == 0);
    }
    recording.close();

    try (FileChannelWrapper channel = NIOUtils.readableChannel(file.toFile())) {
      DemuxerTrack track = MP4Demuxer.createMP4Demuxer(channel).getVideoTrack();
      assertThat(track.getMeta().getTotalFrames()).isEqualTo(50);
      // 49 periods of 40 ms, and the last picture for 1/30 s
      assertThat(track.getMeta().getTotalDuration())
          .isCloseTo(49 * 0.04 + 1 / 30.0, Offset.offset(0.001));
      assertThat(track.getMeta().getSeekFrames()).containsExactly(0, 25);
    }
    assertThat(brightness(30)).isCloseTo(130, Offset.offset(4));
    assertThat(recording.pictures()).isEqualTo(50);
    assertThat(recording.failure()).isEmpty();
  }

  @Test
  @NeedsTool(Tool.FFMPEG)
  void whatIsWrittenPlaysToTheLastSecondThoughNobodyClosesIt() throws Exception {
    for (int i = 0; i < 90; i++) { // 3.6 s
      film(64, 48, 100 + i, i % 25 == 0);
    }

    // A killed program leaves what it has written, and perhaps a part of the next fragment.
    Path killed = Files.copy(file, folder.resolve("killed.mp4"));
    byte[] whole = Files.readAllBytes(killed);
    assertThat(brightnessByFfmpeg(killed)).hasSize(78).last().isEqualTo(177);
    Path torn = Files.write(folder.resolve("torn.mp4"), Arrays.copyOf(whole, whole.length - 60));
    assertThat(brightnessByFfmpeg(torn)).hasSizeBetween(65, 78);
    recording.close();
    assertThat(brightnessByFfmpeg(file)).hasSize(90).last().isEqualTo(189);
  }

  @Test
  @NeedsTool(Tool.FFMPEG)
  void aFilmThatCannotBeEndedStillPlays() throws Exception {
    for (int i = 0; i < 30; i++) {
      film(64, 48, 100 + i, i == 0);
    }
    Path fragments = Files.copy(file, folder.resolve("fragments.mp4"));
    recording.close();
    byte[] closed = Files.readAllBytes(file);
    byte[] header = Files.readAllBytes(fragments);
    // The movie box at the end was written, but not the 16 bytes that make the fragments its data.
    System.arraycopy(header, 0, closed, 0, 100);
    Path between = Files.write(folder.resolve("between.mp4"), closed);

    assertThat(brightnessByFfmpeg(between)).hasSize(30);
  }

  /** Returns the rounded luma of each picture, decoded by an independent decoder. */
  private List<Integer> brightnessByFfmpeg(Path film) throws IOException, InterruptedException {
    Ffmpeg.Decoded decoded = Ffmpeg.decodeFile(film, 64 * 48, folder);
    return decoded.pictures().stream()
        .map(picture -> (picture[0] & 0xff) * 219.0 / 255 + 16) // its black is 0, not 16
        .map(level -> (int) Math.round(level))
        .toList();
  }

  @Test
  void itBeginsWithAKeyPicture() throws IOException {
    film(64, 48, 100, true);
    recording.close();
    file = folder.resolve("second.mp4");
    recording = Recording.to(file);
    film(64, 48, 110, false);
    film(64, 48, 120, true);
    film(64, 48, 130, false);
    recording.close();

    assertThat(recording.pictures()).isEqualTo(2);
  }

  @Test
  void picturesOfAnotherSizeEndItAndWhatWasRecordedStays() throws IOException, JCodecException {
    film(64, 48, 100, true);
    film(64, 48, 100, false);
    encoder = new H264Encoder(32, 32);
    film(32, 32, 100, true);

    assertThat(recording.failure().map(Phrase::english))
        .contains("the recording " + file + " ended, because the pictures have another size now");
    assertThat(recording.pictures()).isEqualTo(2);
    assertThat(brightness(1)).isCloseTo(100, Offset.offset(4));
  }

  @Test
  void aRecordingOfNothingLeavesNoFile() throws IOException {
    recording.close();

    assertThat(recording.pictures()).isZero();
    assertThat(file).doesNotExist();
  }

  @Test
  void aFileThatExistsIsNotOverwritten() throws IOException {
    Path precious = Files.writeString(folder.resolve("precious.mp4"), "x");

    assertThatThrownBy(() -> Recording.to(precious)).isInstanceOf(FileAlreadyExistsException.class);
    assertThat(Files.readString(precious)).isEqualTo("x");
  }

  @Test
  void nothingHappensAfterItsEnd() throws IOException {
    film(64, 48, 100, true);
    recording.close();
    long size = Files.size(file);
    film(64, 48, 100, true);
    recording.close();

    assertThat(Files.size(file)).isEqualTo(size);
    assertThat(recording.pictures()).isEqualTo(1);
  }

  private void film(int width, int height, int level, boolean key) {
    Picture picture = new Picture(width, height);
    Arrays.fill(picture.y(), (byte) level);
    AccessUnit encoded = encoder.encode(picture, key);
    recording.filmed(new FilmedPicture(picture, Optional.of(encoded), VideoFigures.NONE, now));
    now += PERIOD;
  }

  private int brightness(int number) throws IOException, JCodecException {
    File source = file.toFile();
    return FrameGrab.getFrameFromFile(source, number).getPlaneData(0)[0] + 128;
  }
}
