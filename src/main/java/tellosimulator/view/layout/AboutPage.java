package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextArea;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.files.IoReason;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The page with the program's version and the licences of all its parts. Confined to the JavaFX
 * thread.
 */
final class AboutPage extends Page {

  private final Messages messages;
  private final Map<String, String> texts = LicenseTexts.all();
  private final ListView<String> documents = Nodes.named(new ListView<>(), "about-documents");
  private final TextArea text = Nodes.named(new TextArea(), "about-text", "document");

  AboutPage(ViewContext context) {
    super("about-page", context.language().messages(AboutPage.class).text("program", version()));
    messages = context.language().messages(AboutPage.class);
    title().setId("about-title");
    documents.getItems().setAll(texts.keySet());
    documents.setCellFactory(list -> new DocumentCell());
    text.setEditable(false);
    addButton("about-close", messages.text("close"));
    layoutParts();
    documents.getSelectionModel().selectedItemProperty().subscribe(this::read);
    documents.getSelectionModel().selectFirst();
  }

  private void layoutParts() {
    HBox library = Nodes.styled(new HBox(documents, text), "library");
    HBox.setHgrow(text, Priority.ALWAYS);
    VBox.setVgrow(library, Priority.ALWAYS);
    Label purpose = messages.label("purpose");
    purpose.setWrapText(true);
    Label versions =
        Nodes.label(
            messages.text(
                "versions",
                System.getProperty("java.version"),
                System.getProperty("javafx.runtime.version", "?"),
                System.getProperty("os.name")),
            "muted");
    versions.setId("about-versions");
    layoutPage(purpose, versions, messages.label("licences", Styles.TEXT_BOLD, "heading"), library);
  }

  private void read(String document) {
    text.setText(document == null ? "" : texts.get(document));
    text.positionCaret(0);
    text.setScrollTop(0);
  }

  /** Returns the version from the jar's manifest, or "development" if there is none. */
  private static String version() {
    return Optional.ofNullable(AboutPage.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  /** A cell that shows a document's name. */
  private final class DocumentCell extends ListCell<String> {
    @Override
    protected void updateItem(String path, boolean empty) {
      super.updateItem(path, empty);
      textProperty().unbind();
      if (empty || path == null) {
        setText("");
      } else if (path.equals(LicenseTexts.NOTICE)) {
        textProperty().bind(messages.text("notice"));
      } else {
        String name = path.substring(path.lastIndexOf('/') + 1);
        setText(name.equals("LICENSE") ? "Apache-2.0" : name.replaceFirst("\\.(txt|md)$", ""));
      }
    }
  }

  /** Reads the program's notice, and the licences that the notice names, from the jar. */
  private static final class LicenseTexts {

    /** The path of the notice in the jar. */
    static final String NOTICE = "META-INF/NOTICE";

    /** The pattern of a licence's path in the notice. */
    private static final Pattern NAMED =
        Pattern.compile("META-INF/(?:LICENSE|licenses/[\\w.-]*\\w)");

    /**
     * The first words of this program's own files. Other jars contain files with the same names.
     */
    private static final List<String> OURS = List.of("Tello Simulator", "Apache License");

    private LicenseTexts() {}

    /** Returns the notice and then each licence that it names; the keys are their paths. */
    static Map<String, String> all() {
      Map<String, String> texts = new LinkedHashMap<>();
      read(NOTICE)
          .ifPresent(
              notice -> {
                texts.put(NOTICE, notice);
                NAMED
                    .matcher(notice)
                    .results()
                    .map(result -> result.group())
                    .forEach(path -> read(path).ifPresent(text -> texts.put(path, text)));
              });
      return Collections.unmodifiableMap(texts);
    }

    private static Optional<String> read(String path) {
      ClassLoader loader = LicenseTexts.class.getClassLoader();
      boolean ambiguous = !path.contains("licenses/");
      try {
        for (URL url : Collections.list(loader.getResources(path))) {
          String text = read(url);
          if (!ambiguous || OURS.stream().anyMatch(text.strip()::startsWith)) {
            return Optional.of(text);
          }
        }
        return Optional.empty();
      } catch (IOException e) {
        return Optional.of(IoReason.of(e).toString());
      }
    }

    private static String read(URL url) throws IOException {
      try (InputStream in = url.openStream()) {
        return new String(in.readAllBytes(), StandardCharsets.UTF_8);
      }
    }
  }
}
