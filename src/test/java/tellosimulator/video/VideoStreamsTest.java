package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import org.assertj.core.data.Offset;
import org.jcodec.common.model.Picture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.profile.Profile;
import tellosimulator.testing.CapturedLog;

/** Video over real sockets, decoded by JCodec. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@Tag("slow")
class VideoStreamsTest {

  /** Maximum change of luma by encoding. */
  private static final int CLOSE = 3;

  private VideoReceiver receiver;

  @BeforeEach
  void open() throws IOException {
    receiver = VideoReceiver.open(0);
  }

  @AfterEach
  void close() {
    receiver.close();
  }

  @Test
  void aStreamBeginsWithParametersInDatagramsOfTheirOwnAndAKeyPicture() throws IOException {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      assertThat(VideoReceiver.type(receiver.unit())).isEqualTo(VideoReceiver.SPS);
      assertThat(VideoReceiver.type(receiver.unit())).isEqualTo(VideoReceiver.PPS);
      assertThat(receiver.lengths()).hasSize(2).allMatch(length -> length < 40);
      assertThat(VideoReceiver.type(receiver.unit())).isEqualTo(VideoReceiver.IDR);
      assertThat(receiver.sender().getAddress()).isEqualTo(drones.address(1).getAddress());
    }
  }

  @Test
  void whatIsSentIsWhatTheCameraSees() throws IOException {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      for (int i = 0; i < 40; i++) {
        Picture picture = receiver.picture();
        assertThat(List.of(picture.getWidth(), picture.getHeight())).containsExactly(960, 720);
        assertThat(brightness(picture)).isCloseTo(FilmedDrones.FIRST, within(CLOSE));
      }
      assertThat(drones.ask(1, "battery?")).isEqualTo("100");
    }
  }

  @Test
  void decodingCanBeginEachSecond() throws IOException {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      receiver.nextSps();
      int pictures = 0;
      int type;
      do {
        type = VideoReceiver.type(receiver.unit());
        pictures += type == VideoReceiver.SPS || type == VideoReceiver.PPS ? 0 : 1;
      } while (type != VideoReceiver.SPS);

      // fewer on a busy machine
      assertThat(pictures).isBetween(2, 31);
      assertThat(drones.ask(1, "streamoff")).isEqualTo("ok");
    }
  }

  @Test
  void afterStreamoffAStreamBeginsAnew() throws IOException {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      receiver.keyPicture();
      receiver.picture();
      drones.ask(1, "streamoff");
      assertThat(receiver.fallsSilent()).isTrue();

      drones.ask(1, "streamon");
      assertThat(VideoReceiver.type(receiver.unit())).isEqualTo(VideoReceiver.SPS);
    }
  }

  @Test
  void askingAgainBringsAKeyPictureAtOnce() throws IOException {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      receiver.keyPicture();
      drones.ask(1, "streamon");
      int pictures = 0;
      while (VideoReceiver.type(receiver.unit()) != VideoReceiver.SPS) {
        pictures++;
      }

      assertThat(pictures).isLessThan(15);
    }
  }

  @Test
  void eachDroneFilmsForItself() throws IOException {
    try (VideoReceiver second = VideoReceiver.open(0);
        FilmedDrones drones = new FilmedDrones(Profile.EDU, receiver.port(), second.port())) {
      for (int drone = 1; drone <= 2; drone++) {
        drones.ask(drone, "command");
        drones.ask(drone, "streamon");
      }

      assertThat(brightness(receiver.keyPicture())).isCloseTo(FilmedDrones.FIRST, within(CLOSE));
      assertThat(brightness(second.keyPicture()))
          .isCloseTo(FilmedDrones.FIRST + FilmedDrones.STEP, within(CLOSE));
    }
  }

  @Test
  void theTalentsSettingsChangeThePicture() throws IOException {
    try (FilmedDrones drones = filming(Profile.TT)) {
      drones.ask(1, "setresolution low");
      assertThat(sizeAfterChange(960)).containsExactly(648, 478);

      drones.ask(1, "downvision 1");
      assertThat(sizeAfterChange(648)).containsExactly(320, 720);
      assertThat(brightness(receiver.keyPicture())).isCloseTo(FilmedDrones.BELOW, within(CLOSE));
    }
  }

  @Test
  void portMovesTheVideo() throws IOException {
    try (VideoReceiver elsewhere = VideoReceiver.open(0);
        FilmedDrones drones = filming(Profile.TT)) {
      receiver.keyPicture();
      assertThat(drones.ask(1, "port 8890 " + elsewhere.port())).isEqualTo("ok");

      assertThat(VideoReceiver.type(elsewhere.unit())).isEqualTo(VideoReceiver.SPS);
    }
  }

  @Test
  void videoGoesToWhoCommandedFirst() throws IOException {
    try (FilmedDrones drones = new FilmedDrones(Profile.EDU, receiver.port());
        DatagramSocket other =
            new DatagramSocket(new InetSocketAddress(InetAddress.getByName("127.0.0.9"), 0))) {
      other.setSoTimeout(10_000);
      drones.ask(1, "command");
      drones.ask(other, 1, "command");
      drones.ask(1, "streamon");

      assertThat(VideoReceiver.type(receiver.unit())).isEqualTo(VideoReceiver.SPS);
    }
  }

  @Test
  void aReceiverThatVanishesAndComesBackFindsTheStream() throws IOException {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      receiver.keyPicture();
      int port = receiver.port();
      receiver.close();
      for (int i = 0; i < 20; i++) {
        assertThat(drones.ask(1, "battery?")).isEqualTo("100");
      }
      receiver = VideoReceiver.open(port);

      assertThat(brightness(receiver.keyPicture())).isCloseTo(FilmedDrones.FIRST, within(CLOSE));
    }
  }

  @Test
  void aDroneThatWasSwitchedOffAndOnFilmsOnlyWhenAskedAgain() throws Exception {
    try (FilmedDrones drones = filming(Profile.EDU)) {
      receiver.keyPicture();
      drones.power(1, false);
      drones.power(1, true);
      drones.ask(1, "command");
      assertThat(receiver.fallsSilent()).isTrue();

      drones.ask(1, "streamon");
      assertThat(brightness(receiver.keyPicture())).isCloseTo(FilmedDrones.FIRST, within(CLOSE));
    }
  }

  @Test
  void aWatcherThatFailsDoesNotHarmTheStream() throws Exception {
    try (CapturedLog log = CapturedLog.of(VideoStream.class);
        FilmedDrones drones = filming(Profile.EDU)) {
      receiver.keyPicture();
      drones.streams().stream(1)
          .watch(
              filmed -> {
                throw new IllegalStateException("broken on purpose");
              });

      assertThat(log.next()).startsWith("A receiver of the video failed; please report this: ");
      assertThat(brightness(receiver.keyPicture())).isCloseTo(FilmedDrones.FIRST, within(CLOSE));
      assertThat(brightness(receiver.keyPicture())).isCloseTo(FilmedDrones.FIRST, within(CLOSE));
    }
  }

  @Test
  void aWatcherSeesThePictureThatIsEncoded() throws Exception {
    BlockingQueue<FilmedPicture> seen = new ArrayBlockingQueue<>(1000);
    try (FilmedDrones drones = filming(Profile.EDU)) {
      drones.streams().stream(1).watch(seen::add);

      FilmedPicture picture = seen.poll(10, TimeUnit.SECONDS);
      while (picture.encoded().isEmpty()) { // rendered before the snapshot included `streamon`
        picture = seen.poll(10, TimeUnit.SECONDS);
      }
      assertThat(picture.picture().y()[0]).isEqualTo((byte) FilmedDrones.FIRST);
    }
  }

  @Test
  void aWatcherSeesPicturesEvenIfNobodyStreams() throws Exception {
    BlockingQueue<FilmedPicture> seen = new ArrayBlockingQueue<>(1000);
    try (FilmedDrones drones = new FilmedDrones(Profile.EDU, receiver.port())) {
      drones.streams().stream(1).watch(seen::add);

      FilmedPicture first = seen.poll(10, TimeUnit.SECONDS);
      assertThat(first.picture().y()[0]).isEqualTo((byte) FilmedDrones.FIRST);
      assertThat(first.encoded()).isEmpty();
    }
  }

  private FilmedDrones filming(Profile profile) throws IOException {
    FilmedDrones drones = new FilmedDrones(profile, receiver.port());
    assertThat(drones.ask(1, "command")).isEqualTo("ok");
    assertThat(drones.ask(1, "streamon")).isEqualTo("ok");
    return drones;
  }

  private List<Integer> sizeAfterChange(int widthBefore) throws IOException {
    Picture picture = receiver.keyPicture();
    while (picture.getWidth() == widthBefore) {
      picture = receiver.keyPicture();
    }
    return List.of(picture.getWidth(), picture.getHeight());
  }

  /** Returns the mean luma of the upper third, which the downward camera fills, too. */
  private static int brightness(Picture picture) {
    int pixels = picture.getWidth() * (picture.getHeight() / 3);
    long sum = 0;
    for (int i = 0; i < pixels; i++) {
      sum += picture.getPlaneData(0)[i] + 128; // JCodec's bytes are signed
    }
    return (int) Math.round((double) sum / pixels);
  }

  private static Offset<Integer> within(int offset) {
    return Offset.offset(offset);
  }
}
