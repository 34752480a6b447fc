/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_XML_H
#define WF_OUT_XML_H
/* Documents for the stylesheets, and the stylesheets themselves. */
#include "base/err.h"
#include <jansson.h>
#include <libxml/tree.h>
#include <stdio.h>

/* Append `value` to `parent` as an element of that name: an object's members become child elements by key,
 * an array's elements become <item>, null an element with the attribute null="yes". Keys that XML cannot
 * say are left out. Returned: the element, or NULL without memory. */
xmlNode *wf_xml_from_json(xmlNode *parent, const char *name, const json_t *value);

/* Apply the stylesheet at `path` to a document. Given: pairs of parameter name and XPath expression, ending
 * at NULL, or NULL. Neither network nor writing is allowed to it. Returned: the new document in *out (free
 * with xmlFreeDoc) and, if f is not NULL, also its serialised form on f. Errors: WF_EINPUT with the place
 * when the stylesheet is wrong, WF_EOUTPUT when it fails or f does. */
enum wf_status wf_xml_transform(const char *path, xmlDoc *document, const char **parameters, FILE *f,
                                xmlDoc **out, struct wf_err *e);

/* Read an XML file. Errors: WF_EINPUT with line and reason. */
enum wf_status wf_xml_read(const char *path, xmlDoc **out, struct wf_err *e);
#endif
