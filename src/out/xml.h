/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_XML_H
#define WF_OUT_XML_H
/* Documents for the stylesheets, and the stylesheets themselves. Nothing but the files of one reports/ folder
 * is read: no network, no other file, no external entity, whatever a document names. */
#include "base/err.h"
#include <jansson.h>
#include <libxml/tree.h>
#include <stdio.h>

/* Append `value` to `parent` as an element of that name: an object's members become child elements by key, an
 * array's elements become <item>, null an element with the attribute null="yes". Keys that are not valid XML
 * names are left out; characters that XML 1.0 does not allow become U+FFFD; of files named from the root the
 * folders are left out. Returned: the element, or NULL
 * without memory. */
xmlNode *wf_xml_from_json(xmlNode *parent, const char *name, const json_t *value);

/* Apply the stylesheet at `path` to a document. What it imports, includes and reads by document() is taken
 * from the folder of `path`, by plain names. Given: file to write the serialised result to, or NULL.
 * Returned: the new document in *out (free with xmlFreeDoc). Errors: WF_EINPUT with the place when the
 * stylesheet is wrong, WF_EOUTPUT when it fails. */
enum wf_status wf_xml_transform(const char *path, xmlDoc *document, FILE *f, xmlDoc **out, struct wf_err *e);

/* Read an XML file. Errors: WF_EINPUT with line and reason. */
enum wf_status wf_xml_read(const char *path, xmlDoc **out, struct wf_err *e);
#endif
