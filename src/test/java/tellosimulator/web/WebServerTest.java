package tellosimulator.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.network.PortTakenException;

final class WebServerTest {

  private static final String OK = "HTTP/1.1 200 OK";
  private static final String FORBIDDEN = "HTTP/1.1 403 Forbidden";

  private final List<String> done = new ArrayList<>();
  private WebServer server;
  private int port;
  private String token;

  /** Pages that answer with what they were asked for. */
  private final class EchoSite implements Site {

    @Override
    public String page() {
      return "page.html";
    }

    @Override
    public void get(WebRequest request) throws IOException {
      request.answer(WebRequest.OK, "got " + request.path());
    }

    @Override
    public void post(WebRequest request) throws IOException {
      done.add(request.path() + " " + request.body().length);
      request.answer(WebRequest.OK, "done");
    }

    @Override
    public void close() {
      done.add("closed");
    }
  }

  @BeforeEach
  void open() throws PortTakenException {
    server =
        new WebServer(
            new EchoSite(), new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), "--web");
    port = server.port();
    token = server.token().text();
  }

  @AfterEach
  void close() {
    server.close();
  }

  private String status(String... lines) throws IOException {
    return WebClient.status(port, lines);
  }

  private String own() {
    return "Host: 127.0.0.1:" + port;
  }

  @Test
  void theLinkOpensThePage() {
    assertThat(server.lines())
        .containsExactly("web: http://127.0.0.1:" + port + "/?token=" + token);

    var page = new WebClient(port, "token=" + token).get("");

    assertThat(page.statusCode()).isEqualTo(200);
    assertThat(page.body()).contains("Take off").contains("data-token=\"" + token + "\"");
    assertThat(page.headers().firstValue("Content-Security-Policy").orElse(""))
        .startsWith("default-src 'self'");
    assertThat(page.headers().firstValue("Set-Cookie").orElse(""))
        .isEqualTo("tello-" + port + "=" + token + "; SameSite=Strict; HttpOnly; Path=/");
  }

  @Test
  void thePageSpeaksTheLanguageOfTheBrowserOrOfTheAddress() throws IOException {
    WebClient client = new WebClient(port, "token=" + token);

    assertThat(client.get("?language=de").body()).contains("<html lang=\"de\">", "Abheben");
    assertThat(client.get("?language=xx").body()).contains("<html lang=\"en\">", "Take off");
  }

  @Test
  void behindAPrefixEverythingIsFound() {
    WebClient client = new WebClient(port, "token=" + token);

    assertThat(client.get("user/ada/proxy/8080/").body()).contains("Take off");
    assertThat(client.get("user/ada/proxy/8080/page.css").body()).contains("#room");
    assertThat(client.get("user/ada/proxy/8080/state").body()).isEqualTo("got state");
  }

  @Test
  void withoutTheTokenThereIsNothingButTheDesign() throws IOException {
    assertThat(status("GET / HTTP/1.1", own())).isEqualTo(FORBIDDEN);
    assertThat(status("GET /state HTTP/1.1", own())).isEqualTo(FORBIDDEN);
    assertThat(status("GET /state?token= HTTP/1.1", own())).isEqualTo(FORBIDDEN);
    assertThat(status("GET /state?token=%zz HTTP/1.1", own())).isNotEqualTo(OK);
    assertThat(status("GET /page.js HTTP/1.1", own())).isEqualTo(OK);
    assertThat(status("POST /page.js HTTP/1.1", own(), "Content-Length: 0")).isEqualTo(FORBIDDEN);
    assertThat(done).isEmpty();
  }

  @Test
  void aCookieOnlyReads() throws IOException {
    String cookie = "Cookie: other=1; tello-" + port + "=" + token;

    assertThat(status("GET /state HTTP/1.1", own(), cookie)).isEqualTo(OK);
    assertThat(status("POST /do HTTP/1.1", own(), cookie, "Content-Length: 0"))
        .isEqualTo(FORBIDDEN);
    assertThat(done).isEmpty();
  }

  @Test
  void anotherHostMakesTheCookieWorthless() throws IOException {
    String cookie = "Cookie: tello-" + port + "=" + token;

    assertThat(status("GET /state HTTP/1.1", "Host: evil.example:" + port, cookie))
        .isEqualTo(FORBIDDEN);
    assertThat(status("GET /state HTTP/1.1", "Host: 127.0.0.1.evil.example", cookie))
        .isEqualTo(FORBIDDEN);
    assertThat(status("GET /state HTTP/1.1", "Host: localhost:" + port, cookie)).isEqualTo(OK);
  }

  @ParameterizedTest
  @ValueSource(strings = {"http://evil.example", "null", "http://127.0.0.1:1", "file://"})
  void aForeignOriginIsRefusedEvenWithTheToken(String origin) throws IOException {
    assertThat(
            status(
                "POST /do?token=" + token + " HTTP/1.1",
                own(),
                "Origin: " + origin,
                "Content-Length: 0"))
        .isEqualTo(FORBIDDEN);
    assertThat(done).isEmpty();
  }

  @Test
  void theOwnOriginIsAllowedAlsoBehindAProxy() throws IOException {
    String post = "POST /do?token=" + token + " HTTP/1.1";

    assertThat(status(post, own(), "Origin: http://127.0.0.1:" + port, "Content-Length: 0"))
        .isEqualTo(OK);
    assertThat(
            status(
                post,
                own(),
                "X-Forwarded-Host: ada.example",
                "Origin: https://ada.example",
                "Content-Length: 0"))
        .isEqualTo(OK);
    assertThat(done).containsExactly("do 0", "do 0");
  }

  @Test
  void noAnswerIsForOtherOrigins() {
    assertThat(new WebClient(port, "token=" + token).get("state").headers().map().keySet())
        .noneMatch(
            header -> header.toLowerCase(java.util.Locale.ROOT).startsWith("access-control"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"PUT", "DELETE", "OPTIONS", "TRACE"})
  void otherMethodsAreRefused(String method) throws IOException {
    assertThat(status(method + " /?token=" + token + " HTTP/1.1", own()))
        .startsWith("HTTP/1.1 405");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"/../page.html", "/%2e%2e/messages.properties", "//etc/x.html", "/x.html"})
  void thereAreNoOtherFiles(String path) throws IOException {
    assertThat(status("GET " + path + "?token=" + token + " HTTP/1.1", own()))
        .matches("HTTP/1.1 (200 OK|404 Not Found)");
    assertThat(new WebClient(port, "token=" + token).get("%2e%2e/Main.html").body())
        .isEqualTo("There is no such page.");
  }

  @Test
  void aBodyThatIsTooLongIsRefused() {
    WebClient client = new WebClient(port, "token=" + token);

    assertThat(client.post("scenario", new byte[WebRequest.MOST_BYTES]).statusCode())
        .isEqualTo(200);
    var answer = client.post("scenario", new byte[WebRequest.MOST_BYTES + 1]);

    assertThat(answer.statusCode()).isEqualTo(400);
    assertThat(answer.body()).isEqualTo("The request is longer than 1 MB.");
  }

  @Test
  void aThousandConnectionsDoNoHarm() throws IOException {
    List<Socket> sockets = new ArrayList<>();
    try {
      for (int i = 0; i < 1000; i++) {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        sockets.add(socket);
        socket.getOutputStream().write("GET / HT".getBytes(StandardCharsets.US_ASCII));
      }
    } finally {
      for (Socket socket : sockets) {
        socket.close();
      }
    }

    String answer = "";
    for (int i = 0; i < 100 && !answer.equals(OK); i++) { // places are freed one after the other
      answer = status("GET /state?token=" + token + " HTTP/1.1", own());
    }
    assertThat(answer).isEqualTo(OK);
  }

  @Test
  @Tag("slow")
  void whoAsksTooSlowlyIsDropped() throws IOException {
    try (Socket slow = new Socket(InetAddress.getLoopbackAddress(), port)) {
      slow.setSoTimeout(30_000);
      slow.getOutputStream().write("GET / HTTP/1.1\r\nX: ".getBytes(StandardCharsets.US_ASCII));

      assertThat(slow.getInputStream().read()).isEqualTo(-1); // the server closes it after 10 s
    }
  }

  @Test
  void aPortThatIsTakenIsNamed() {
    assertThatThrownBy(
            () ->
                new WebServer(
                    new EchoSite(),
                    new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
                    "--web"))
        .isInstanceOf(PortTakenException.class)
        .hasMessageContaining(Integer.toString(port))
        .hasMessageContaining("--web");
  }

  @Test
  void thePagesEndWithTheServer() throws IOException {
    server.close();

    assertThat(done).containsExactly("closed");
    assertThatThrownBy(() -> status("GET / HTTP/1.1", own())).isInstanceOf(IOException.class);
  }
}
