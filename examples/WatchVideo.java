import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import javax.swing.ImageIcon;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import org.jcodec.codecs.h264.H264Decoder;
import org.jcodec.common.model.Picture;

/**
 * Shows what the drone's camera sees, or saves a picture each second.
 *
 * <p>Start the simulator first, in another terminal: {@code mvn javafx:run}, and switch the drone
 * on. This needs a decoder for H.264; JCodec is in the simulator's jar:
 *
 * <pre>java -cp target/tello-simulator.jar examples/WatchVideo.java [host] [port] [video port]
 *     [folder] [pictures]</pre>
 *
 * <p>Without arguments it shows a window with the video of the simulator on this machine
 * (127.0.0.1, port 8879, video on port 11111). With a folder it saves pictures there instead, and
 * ends after 5 of them or as many as asked for. A real Tello has host 192.168.10.1 and port 8889.
 * Meanwhile fly the drone with another program, such as FirstFlight. While a command of that one
 * runs, the drone takes no other, so this one waits for its turn.
 */
public final class WatchVideo {

  private static final int PATIENCE_MS = 20_000;

  /** What the drone answers while it carries out another command, and how long that may take. */
  private static final String BUSY = "error Not joystick";

  private static final int BUSY_SECONDS = 60;

  /** A datagram that is not as long as this is the last one of its NAL unit. */
  private static final int FULL = 1460;

  private static final int PICTURES_A_SECOND = 30;

  /** Kinds of NAL units; see ITU-T H.264, table 7-1. */
  private static final int SEQUENCE_PARAMETERS = 7;

  private static final int PICTURE_PARAMETERS = 8;

  private final DatagramSocket video;
  private final H264Decoder decoder = new H264Decoder();
  private final byte[][] planes = new byte[3][960 * 720 * 2];
  private boolean begun;

  private WatchVideo(DatagramSocket video) {
    this.video = video;
  }

  /** Takes pictures as they come; returns whether it wants more. */
  private interface Viewer {
    boolean show(BufferedImage image) throws IOException;
  }

  public static void main(String[] args) {
    String host = args.length > 0 ? args[0] : "127.0.0.1";
    int port = args.length > 1 ? Integer.parseInt(args[1]) : 8879;
    int videoPort = args.length > 2 ? Integer.parseInt(args[2]) : 11111;
    int pictures = args.length > 4 ? Integer.parseInt(args[4]) : 5;
    if (args.length <= 3 && GraphicsEnvironment.isHeadless()) {
      fail("There is no display. Give host, port, video port and a folder to save pictures.");
    }
    try (DatagramSocket video = new DatagramSocket(videoPort);
        DatagramSocket commands = new DatagramSocket()) {
      video.setReceiveBufferSize(1 << 20); // room for pictures while one is being decoded
      video.setSoTimeout(PATIENCE_MS);
      commands.connect(new InetSocketAddress(host, port));
      commands.setSoTimeout(PATIENCE_MS);
      command(commands, "command");
      command(commands, "streamon");
      try {
        new WatchVideo(video).watch(args.length > 3 ? saver(args[3], pictures) : window());
      } finally {
        command(commands, "streamoff"); // whatever went wrong: never leave a stream on
      }
    } catch (PortUnreachableException e) {
      fail(
          "Nothing listens at " + host + ":" + port + ". Does the simulator run, is the drone on?");
    } catch (SocketTimeoutException e) {
      fail("Nothing came from " + host + ":" + port + ". Is the drone on?");
    } catch (IOException e) {
      fail("There is no video: " + e.getMessage());
    }
  }

  /** Takes pictures as long as the viewer wants them. */
  private void watch(Viewer viewer) throws IOException {
    boolean wanted = true;
    while (wanted) {
      ByteBuffer access = accessUnit();
      BufferedImage image = decode(access);
      wanted = image == null || viewer.show(image);
    }
  }

  /** All that belongs to the next picture: its parameters, if it has some, and the picture. */
  private ByteBuffer accessUnit() throws IOException {
    ByteArrayOutputStream access = new ByteArrayOutputStream();
    int kind;
    do {
      byte[] unit = nalUnit();
      kind = unit.length > 4 ? unit[4] & 0x1f : 0; // after the start code 00 00 00 01
      begun |= kind == SEQUENCE_PARAMETERS;
      access.writeBytes(unit);
    } while (kind == SEQUENCE_PARAMETERS || kind == PICTURE_PARAMETERS);
    return ByteBuffer.wrap(access.toByteArray());
  }

  /** The drone begins each NAL unit in a new datagram, and only its last one is shorter. */
  private byte[] nalUnit() throws IOException {
    ByteArrayOutputStream unit = new ByteArrayOutputStream();
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    do {
      video.receive(packet);
      unit.write(packet.getData(), 0, packet.getLength());
    } while (packet.getLength() == FULL);
    return unit.toByteArray();
  }

  /** The picture; null if decoding cannot begin yet, or if something was lost. */
  private BufferedImage decode(ByteBuffer access) {
    if (!begun) {
      return null;
    }
    try {
      return image(decoder.decodeFrame(access, planes));
    } catch (RuntimeException e) {
      System.err.println("A picture was damaged; the next one with parameters mends it.");
      begun = false;
      return null;
    }
  }

  /** From brightness and two colour differences (ITU-R BT.601) to red, green and blue. */
  private static BufferedImage image(Picture picture) {
    int width = picture.getCroppedWidth();
    int height = picture.getCroppedHeight();
    byte[] lights = picture.getPlaneData(0);
    byte[] blues = picture.getPlaneData(1);
    byte[] reds = picture.getPlaneData(2);
    int[] rgb = new int[width * height];
    for (int y = 0; y < height; y++) {
      int bright = y * picture.getPlaneWidth(0);
      int color = y / 2 * picture.getPlaneWidth(1);
      for (int x = 0; x < width; x++) {
        // JCodec's bytes are signed, 128 less than in the standard; factors are times 1024
        int light = 1192 * (lights[bright + x] + 128 - 16) + 512;
        int blue = blues[color + x / 2];
        int red = reds[color + x / 2];
        rgb[y * width + x] =
            byteOf(light + 1634 * red) << 16
                | byteOf(light - 401 * blue - 832 * red) << 8
                | byteOf(light + 2066 * blue);
      }
    }
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    image.getRaster().setDataElements(0, 0, width, height, rgb);
    return image;
  }

  private static int byteOf(int value) {
    return Math.max(0, Math.min(255, value >> 10));
  }

  private static Viewer saver(String folder, int pictures) throws IOException {
    File directory = new File(folder);
    if (!directory.isDirectory() && !directory.mkdirs()) {
      throw new IOException("the folder " + folder + " cannot be made");
    }
    int[] seen = {0};
    return image -> {
      if (seen[0] % PICTURES_A_SECOND == 0) {
        File file = new File(directory, "picture-" + seen[0] / PICTURES_A_SECOND + ".png");
        ImageIO.write(image, "png", file);
        System.out.println(
            "Saved " + file + ", " + image.getWidth() + " by " + image.getHeight() + " pixels");
      }
      seen[0]++;
      return seen[0] <= (pictures - 1) * PICTURES_A_SECOND;
    };
  }

  private static Viewer window() {
    JLabel label = new JLabel(new ImageIcon(new BufferedImage(960, 720, 1)));
    JFrame frame = new JFrame("Tello");
    SwingUtilities.invokeLater(
        () -> {
          frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
          frame.add(label);
          frame.pack();
          frame.setVisible(true);
        });
    boolean[] opened = {false};
    return image -> {
      SwingUtilities.invokeLater(() -> label.setIcon(new ImageIcon(image)));
      opened[0] |= frame.isVisible();
      return frame.isVisible() || !opened[0];
    };
  }

  private static void command(DatagramSocket commands, String text) throws IOException {
    String answer = ask(commands, text);
    for (int i = 0; i < BUSY_SECONDS && answer.equals(BUSY); i++) {
      pause();
      answer = ask(commands, text);
    }
    if (!answer.equals("ok")) {
      throw new IOException("the drone answered `" + answer + "` to `" + text + "`");
    }
  }

  private static String ask(DatagramSocket commands, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    commands.send(new DatagramPacket(bytes, bytes.length));
    DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
    commands.receive(reply);
    String answer =
        new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII).strip();
    System.out.println(text + " -> " + answer);
    return answer;
  }

  /** For a second. */
  private static void pause() throws IOException {
    try {
      Thread.sleep(1000);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted");
    }
  }

  private static void fail(String message) {
    System.err.println(message);
    System.exit(1);
  }
}
