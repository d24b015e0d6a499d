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
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** Which program this is, and the licences of all that is in it. For the JavaFX thread. */
final class AboutPage extends Page {

  private final Messages messages;
  private final Map<String, String> texts = LicenseTexts.all();
  private final Label purpose = new Label();
  private final Label versions = new Label();
  private final Label licenses = new Label();
  private final ListView<String> documents = new ListView<>();
  private final TextArea text = new TextArea();

  AboutPage(ViewContext context) {
    super(
        "about-page",
        "about-page",
        context.language().messages(AboutPage.class).text("program", version()));
    messages = context.language().messages(AboutPage.class);
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeParts() {
    title().setId("about-title");
    versions.setId("about-versions");
    versions.getStyleClass().add("muted");
    purpose.setWrapText(true);
    licenses.getStyleClass().addAll(Styles.TEXT_BOLD, "heading");
    documents.setId("about-documents");
    documents.getItems().setAll(texts.keySet());
    documents.setCellFactory(list -> new DocumentCell());
    text.setId("about-text");
    text.setEditable(false);
    text.getStyleClass().add("document");
    addButton("about-close", messages.text("close"));
  }

  private void layoutParts() {
    HBox library = new HBox(documents, text);
    library.getStyleClass().add("library");
    HBox.setHgrow(text, Priority.ALWAYS);
    VBox.setVgrow(library, Priority.ALWAYS);
    layoutPage(purpose, versions, licenses, library);
  }

  private void setupEventHandlers() {
    documents
        .getSelectionModel()
        .selectedItemProperty()
        .addListener((observed, before, chosen) -> read(chosen));
    documents.getSelectionModel().selectFirst();
  }

  private void setupBindings() {
    purpose.textProperty().bind(messages.text("purpose"));
    licenses.textProperty().bind(messages.text("licences"));
    versions
        .textProperty()
        .bind(
            messages.text(
                "versions",
                System.getProperty("java.version"),
                System.getProperty("javafx.runtime.version", "?"),
                System.getProperty("os.name")));
  }

  private void read(String document) {
    text.setText(document == null ? "" : texts.get(document));
    text.positionCaret(0);
    text.setScrollTop(0);
  }

  /** From the jar's manifest. */
  private static String version() {
    return Optional.ofNullable(AboutPage.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  /** A document by its file's name. */
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

  /** The notice of the program and the licences that it names, as they lie in the jar. */
  private static final class LicenseTexts {

    /** The notice, in the jar. */
    static final String NOTICE = "META-INF/NOTICE";

    /** How the notice names a licence. */
    private static final Pattern NAMED =
        Pattern.compile("META-INF/(?:LICENSE|licenses/[\\w.-]*\\w)");

    /** Other jars have files of the same names; ours begin, or go on, with one of these. */
    private static final List<String> OURS = List.of("Tello Simulator", "Apache License");

    private LicenseTexts() {}

    /** The notice, then each licence that it names, by their paths. */
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
