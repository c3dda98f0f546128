//! Tables and figures as plain data, rendered to CSV, JSON, Markdown, SVG, PNG and HTML.
